// Half of a steel sphere of radius 10 mm on half of a steel block, cut by z = 0. Lengths in mm.
R = 10;
core = R / 2;
slope = Tan(40 * Pi / 180);
W = 10;

Point(201) = {-W, -W, 0};
Point(202) = {W, -W, 0};
Point(203) = {W, -W, W};
Point(204) = {-W, -W, W};
For i In {1:3}
  Line(200 + i) = {200 + i, 201 + i};
EndFor
Line(204) = {204, 201};
Curve Loop(201) = {201:204};
Plane Surface(201) = {201};
Transfinite Curve {201, 203} = 8 + 1;
Transfinite Curve {202, 204} = 4 + 1;
Transfinite Surface {201};
Recombine Surface {201};
block[] = Extrude {0, W, 0} { Surface{201}; Layers{4}; Recombine; };

edge = 1 / Sqrt(1 + slope^2);
corner = 1 / Sqrt(1 + 2 * slope^2);

Point(100) = {0, R, 0};
Macro Patch
  Point(n + 1) = {0, R - r, 0};
  Point(n + 2) = {r * slope * edge, R - r * edge, 0};
  Point(n + 3) = {r * slope * corner, R - r * corner, r * slope * corner};
  Point(n + 4) = {0, R - r * edge, r * slope * edge};
  Point(n + 5) = {-r * slope * edge, R - r * edge, 0};
  Point(n + 6) = {-r * slope * corner, R - r * corner, r * slope * corner};
  Circle(n + 1) = {n + 1, 100, n + 2};
  Circle(n + 2) = {n + 2, 100, n + 3};
  Circle(n + 3) = {n + 3, 100, n + 4};
  Circle(n + 4) = {n + 4, 100, n + 1};
  Circle(n + 5) = {n + 1, 100, n + 5};
  Circle(n + 6) = {n + 5, 100, n + 6};
  Circle(n + 7) = {n + 6, 100, n + 4};
  Curve Loop(n + 1) = {n + 1, n + 2, n + 3, n + 4};
  Surface(n + 1) = {n + 1} In Sphere {100};
  Curve Loop(n + 2) = {-(n + 4), -(n + 7), -(n + 6), -(n + 5)};
  Surface(n + 2) = {n + 2} In Sphere {100};
Return
r = R;
n = 110;
Call Patch;
r = core;
n = 120;
Call Patch;
For i In {1:6}
  Line(130 + i) = {110 + i, 120 + i};
EndFor
Curve Loop(131) = {111, 132, -121, -131};
Curve Loop(132) = {112, 133, -122, -132};
Curve Loop(133) = {113, 134, -123, -133};
Curve Loop(134) = {114, 131, -124, -134};
Curve Loop(135) = {115, 135, -125, -131};
Curve Loop(136) = {116, 136, -126, -135};
Curve Loop(137) = {117, 134, -127, -136};
For i In {1:7}
  Plane Surface(130 + i) = {130 + i};
EndFor
Surface Loop(100) = {111, 121, 131:134};
Volume(100) = {100};
Surface Loop(101) = {112, 122, 134, 135, 136, 137};
Volume(101) = {101};
Transfinite Curve {111:117, 121:127} = 4 + 1;
Transfinite Curve {131:136} = 3 + 1;
Transfinite Surface {111, 112, 121, 122, 131:137};
Recombine Surface {111, 112, 121, 122, 131:137};
Transfinite Volume {100, 101};

Physical Volume("sphere") = {100, 101};
Physical Surface("sphere surface") = {111, 112};
Physical Surface("sphere core") = {121, 122};
Physical Surface("sphere side z") = {131, 135};
Physical Volume("block") = {block[1]};
Physical Surface("block top") = {block[0]};
Physical Surface("block bottom") = {201};
Physical Surface("block side z") = {block[2]};
Physical Surface("block end") = {block[5]};
