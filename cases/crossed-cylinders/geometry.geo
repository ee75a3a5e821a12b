// Quarters of two steel cylinders that cross at a right angle and touch at the origin: radius 10 mm about an axis along x
// above, radius 30 mm about an axis along z below. Of each there is the part around the contact: a sector between its
// surface and a concentric core. Lengths in mm.
SetFactory("OpenCASCADE");  // its Extrude leaves the two points at the origin apart
R1 = 10;
R2 = 30;
depth = 8;  // from the surface to the core
L = 10;     // half of the lengths

Macro Sector  // in the plane spanned by y and (ux, uz): centre, radius and angle; points and curves numbered from n
  Point(n) = {0, side * R, 0};
  Point(n + 1) = {0, 0, 0};
  Point(n + 2) = {ux * R * Sin(angle), side * R * (1 - Cos(angle)), uz * R * Sin(angle)};
  Point(n + 3) = {ux * (R - depth) * Sin(angle), side * (R - (R - depth) * Cos(angle)), uz * (R - depth) * Sin(angle)};
  Point(n + 4) = {0, side * depth, 0};
  Circle(n + 1) = {n + 1, n, n + 2};
  Line(n + 2) = {n + 2, n + 3};
  Circle(n + 3) = {n + 3, n, n + 4};
  Line(n + 4) = {n + 4, n + 1};
  Curve Loop(n + 1) = {n + 1, n + 2, n + 3, n + 4};
  Plane Surface(n + 1) = {n + 1};
  Transfinite Curve {n + 1, n + 2, n + 3, n + 4} = 4 + 1;
  Transfinite Surface {n + 1};
  Recombine Surface {n + 1};
Return

n = 100;
side = 1;
R = R1;
ux = 0;
uz = 1;
angle = 45 * Pi / 180;
Call Sector;
upper[] = Extrude {L, 0, 0} { Surface{101}; Layers{4}; Recombine; };

n = 200;
side = -1;
R = R2;
ux = 1;
uz = 0;
angle = 20 * Pi / 180;
Call Sector;
lower[] = Extrude {0, 0, L} { Surface{201}; Layers{4}; Recombine; };

Physical Volume("upper") = {upper[1]};
Physical Surface("upper surface") = {upper[2]};
Physical Surface("upper core") = {upper[4]};
Physical Surface("upper side x") = {101};
Physical Surface("upper side z") = {upper[5]};
Physical Volume("lower") = {lower[1]};
Physical Surface("lower surface") = {lower[2]};
Physical Surface("lower core") = {lower[4]};
Physical Surface("lower side x") = {lower[5]};
Physical Surface("lower side z") = {201};
