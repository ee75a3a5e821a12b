// Steel sphere of radius 10 mm (its lower half) on a steel cylinder of radius 40 mm and height 40 mm, in the meridional
// plane: x is the radius, y the axis. They touch at the origin. Lengths in mm.
R = 10;
core = R / 2;
W = 40;

Point(101) = {0, R, 0};
Point(111) = {0, 0, 0};
Point(112) = {R, R, 0};
Point(121) = {0, R - core, 0};
Point(122) = {core, R, 0};
Circle(111) = {111, 101, 112};
Circle(121) = {121, 101, 122};
Line(131) = {121, 111};
Line(132) = {122, 112};
Curve Loop(101) = {131, 111, -132, -121};
Plane Surface(101) = {101};
Transfinite Curve {111, 121} = 8 + 1;
Transfinite Curve {131, 132} = 3 + 1;
Transfinite Surface {101};
Recombine Surface {101};

Point(201) = {0, -W, 0};
Point(202) = {W, -W, 0};
Point(203) = {W, 0, 0};
Point(204) = {0, 0, 0};
Line(201) = {201, 202};
Line(202) = {202, 203};
Line(203) = {203, 204};
Line(204) = {204, 201};
Curve Loop(201) = {201, 202, 203, 204};
Plane Surface(201) = {201};
Transfinite Curve {201, 203} = 10 + 1;
Transfinite Curve {202, 204} = 10 + 1;
Transfinite Surface {201};
Recombine Surface {201};

Physical Surface("sphere") = {101};
Physical Curve("sphere surface") = {111};
Physical Curve("sphere core") = {121};
Physical Curve("sphere axis") = {131};
Physical Surface("base") = {201};
Physical Curve("base top") = {203};
Physical Curve("base bottom") = {201};
Physical Curve("base axis") = {204};
