// Braces opened in one branch and closed later
#version 3.7;
#declare M = 0;
#declare U =
#if (M) merge { #else union { #end
  sphere { 0, 1 } sphere { 2*x, 1 }
}
#debug concat(vstr(3, max_extent(U), ",", 0, 6), "\n") // expect: 3.000000,1.000000,1.000000
