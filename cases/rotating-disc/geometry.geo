// Quarter of a disc of diameter 300 with a bore of diameter 40; lengths in mm
a = 20;
b = 150;

Point(1) = {0, 0, 0};
Point(2) = {a, 0, 0};
Point(3) = {b, 0, 0};
Point(4) = {0, b, 0};
Point(5) = {0, a, 0};
Line(1) = {2, 3};
Circle(2) = {3, 1, 4};
Line(3) = {4, 5};
Circle(4) = {5, 1, 2};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve {2, 4} = 4 + 1;                       // four cells along each arc
Transfinite Curve {1} = 4 + 1 Using Progression 1.6;    // four layers, thin at the bore
Transfinite Curve {-3} = 4 + 1 Using Progression 1.6;
Transfinite Surface {1};
Recombine Surface {1};

Physical Surface("disc") = {1};
Physical Curve("y symmetry") = {1};
Physical Curve("rim") = {2};
Physical Curve("x symmetry") = {3};
Physical Curve("bore") = {4};
