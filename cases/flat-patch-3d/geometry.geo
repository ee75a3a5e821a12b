// Two blocks of 40 mm x 20 mm x 30 mm, one on the other, with meshes that do not match. Lengths in mm.
SetFactory("OpenCASCADE");  // its Extrude leaves the points of the two blocks apart
W = 40;
H = 20;
D = 30;

Macro Brick  // from y to y + H; points and curves numbered from n, with nx, ny and nz cells
  Point(n + 1) = {0, y, 0};
  Point(n + 2) = {W, y, 0};
  Point(n + 3) = {W, y, D};
  Point(n + 4) = {0, y, D};
  For i In {1:4}
    Line(n + i) = {n + i, n + 1 + (i % 4)};
  EndFor
  Curve Loop(n) = {n + 1, n + 2, n + 3, n + 4};
  Plane Surface(n) = {n};
  Transfinite Curve {n + 1, n + 3} = nx + 1;
  Transfinite Curve {n + 2, n + 4} = nz + 1;
  Transfinite Surface {n};
  Recombine Surface {n};
  brick[] = Extrude {0, H, 0} { Surface{n}; Layers{ny}; Recombine; };
Return

n = 100;
y = 0;
nx = 7;
ny = 3;
nz = 4;
Call Brick;
upper[] = brick[];
n = 200;
y = -H;
nx = 9;
ny = 4;
nz = 5;
Call Brick;
lower[] = brick[];

Physical Volume("upper") = {upper[1]};
Physical Surface("upper face") = {100};
Physical Surface("upper top") = {upper[0]};
Physical Surface("upper side x") = {upper[5]};
Physical Surface("upper side z") = {upper[2]};
Physical Volume("lower") = {lower[1]};
Physical Surface("lower face") = {lower[0]};
Physical Surface("lower bottom") = {200};
Physical Surface("lower side x") = {lower[5]};
Physical Surface("lower side z") = {lower[2]};
