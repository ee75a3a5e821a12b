// Shaft of diameter 30 with a shoulder of diameter 45, fillet radius 3; lengths in mm
d = 30;
D = 45;
r = 3;
L = 45;                  // of each part

Point(1) = {0, 0, 0};
Point(2) = {D / 2, 0, 0};
Point(3) = {D / 2, L, 0};
Point(4) = {d / 2 + r, L, 0};
Point(5) = {d / 2, L + r, 0};
Point(6) = {d / 2, 2 * L, 0};
Point(7) = {0, 2 * L, 0};
Point(8) = {d / 2 + r, L + r, 0};   // middle of the fillet
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Circle(4) = {4, 8, 5};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7};
Plane Surface(1) = {1};
Mesh.MeshSizeMax = 8;
Mesh.MeshSizeMin = 2;

Physical Surface("shaft") = {1};
Physical Curve("thick end") = {1};
Physical Curve("thick part") = {2};
Physical Curve("shoulder") = {3};
Physical Curve("fillet") = {4};
Physical Curve("thin part") = {5};
Physical Curve("thin end") = {6};
Physical Curve("axis") = {7};
