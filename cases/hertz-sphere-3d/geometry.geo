// A quarter of a steel sphere of radius 10 mm on a quarter of a steel block. Of the sphere there is the part around the
// contact: between its surface, a concentric core, the planes of symmetry x = 0 and z = 0, and two planes through its
// centre. It touches the block y < 0 at the origin. Lengths in mm.
R = 10;
core = R / 2;
slope = Tan(40 * Pi / 180);
W = 10;

// first: what is extruded later would share its points with what is drawn already
Point(201) = {0, -W, 0};
Point(202) = {W, -W, 0};
Point(203) = {W, -W, W};
Point(204) = {0, -W, W};
For i In {1:3}
  Line(200 + i) = {200 + i, 201 + i};
EndFor
Line(204) = {204, 201};
Curve Loop(201) = {201:204};
Plane Surface(201) = {201};
Transfinite Curve {201:204} = 4 + 1;
Transfinite Surface {201};
Recombine Surface {201};
block[] = Extrude {0, W, 0} { Surface{201}; Layers{4}; Recombine; };

edge = 1 / Sqrt(1 + slope^2);        // of directions along a plane of symmetry
corner = 1 / Sqrt(1 + 2 * slope^2);  // of the direction between them

Point(100) = {0, R, 0};
Macro Patch  // on the sphere of radius r about the centre, points and curves numbered from n
  Point(n + 1) = {0, R - r, 0};
  Point(n + 2) = {r * slope * edge, R - r * edge, 0};
  Point(n + 3) = {r * slope * corner, R - r * corner, r * slope * corner};
  Point(n + 4) = {0, R - r * edge, r * slope * edge};
  Circle(n + 1) = {n + 1, 100, n + 2};
  Circle(n + 2) = {n + 2, 100, n + 3};
  Circle(n + 3) = {n + 3, 100, n + 4};
  Circle(n + 4) = {n + 4, 100, n + 1};
  Curve Loop(n + 1) = {n + 1, n + 2, n + 3, n + 4};
  Surface(n + 1) = {n + 1} In Sphere {100};
Return
r = R;
n = 110;
Call Patch;
r = core;
n = 120;
Call Patch;
For i In {1:4}
  Line(130 + i) = {110 + i, 120 + i};
EndFor
For i In {1:4}
  Curve Loop(130 + i) = {110 + i, 131 + (i % 4), -(120 + i), -(130 + i)};
  Plane Surface(130 + i) = {130 + i};
EndFor
Surface Loop(100) = {111, 121, 131:134};
Volume(100) = {100};
Transfinite Curve {111:114, 121:124} = 4 + 1;
Transfinite Curve {131:134} = 3 + 1;
Transfinite Surface {111, 121, 131:134};
Recombine Surface {111, 121, 131:134};
Transfinite Volume {100};

Physical Volume("sphere") = {100};
Physical Surface("sphere surface") = {111};
Physical Surface("sphere core") = {121};
Physical Surface("sphere side x") = {134};
Physical Surface("sphere side z") = {131};
Physical Volume("block") = {block[1]};
Physical Surface("block top") = {block[0]};
Physical Surface("block bottom") = {201};
Physical Surface("block side x") = {block[5]};
Physical Surface("block side z") = {block[2]};
