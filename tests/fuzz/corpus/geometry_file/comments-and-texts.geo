// a comment with Save in it
/* one over
   lines, SystemCall "x" */ Point(1) = {0, 0, 0};
Printf("Exit; %g", 1); s = 'Print';
Include "parts/other.geo"; Merge
  "mesh.msh";
Savings = 1; _Exit2 = 2; /* never closed
