// Quarter of a flat bar 100 wide and 200 long with a hole of diameter 20; lengths in mm
r = 10;
h = 50;
L = 100;

Point(1) = {0, 0, 0};    // middle of the hole
Point(2) = {r, 0, 0};
Point(3) = {0, r, 0};
Point(4) = {0, h, 0};
Point(5) = {L, h, 0};
Point(6) = {L, 0, 0};
Circle(1) = {2, 1, 3};
Line(2) = {3, 4};
Line(3) = {4, 5};
Line(4) = {5, 6};
Line(5) = {6, 2};
Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {1};
Mesh.MeshSizeMax = 20;   // the program refines where the stress asks for it

Physical Surface("bar") = {1};
Physical Curve("hole") = {1};
Physical Curve("middle") = {2};
Physical Curve("side") = {3};
Physical Curve("end") = {4};
Physical Curve("axis") = {5};
