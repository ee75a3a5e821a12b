// Two blocks of 40 mm x 20 mm, one on the other, with meshes that do not match. Lengths in mm.
W = 40;
H = 20;

Point(101) = {0, 0, 0};
Point(102) = {W, 0, 0};
Point(103) = {W, H, 0};
Point(104) = {0, H, 0};
Line(101) = {101, 102};
Line(102) = {102, 103};
Line(103) = {103, 104};
Line(104) = {104, 101};
Curve Loop(101) = {101, 102, 103, 104};
Plane Surface(101) = {101};
Transfinite Curve {101, 103} = 7 + 1;
Transfinite Curve {102, 104} = 3 + 1;
Transfinite Surface {101};
Recombine Surface {101};

Point(201) = {0, -H, 0};
Point(202) = {W, -H, 0};
Point(203) = {W, 0, 0};
Point(204) = {0, 0, 0};
Line(201) = {201, 202};
Line(202) = {202, 203};
Line(203) = {203, 204};
Line(204) = {204, 201};
Curve Loop(201) = {201, 202, 203, 204};
Plane Surface(201) = {201};
Transfinite Curve {201, 203} = 9 + 1;
Transfinite Curve {202, 204} = 4 + 1;
Transfinite Surface {201};
Recombine Surface {201};

Physical Surface("upper") = {101};
Physical Curve("upper face") = {101};
Physical Curve("upper top") = {103};
Physical Curve("upper side") = {104};
Physical Surface("lower") = {201};
Physical Curve("lower face") = {203};
Physical Curve("lower bottom") = {201};
Physical Curve("lower side") = {204};
