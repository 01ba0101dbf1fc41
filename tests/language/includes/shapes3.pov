// More solids from macros: tubes, columns, eggs, pyramids
#version 3.7;
global_settings { assumed_gamma 1 }
#include "shapes3.inc"
#macro Say(O) #debug concat(vstr(3, min_extent(O), ",", 0, 3), " ", vstr(3, max_extent(O), ",", 0, 3), "\n") #end
#declare A = object { Column_N(6, 0.5, 2) } Say(A)
#declare B = object { Egg_Shape(1.15, 1.55) }
#debug concat(str(inside(B, y*1.2), 0, 0), str(inside(B, y*5), 2, 0), "\n")
#declare C = object { Facetted_Sphere(4, 8) } Say(C)
#declare D = object { Pyramid_N(4, 1, 0.5, 2) }
#debug concat(str(inside(D, <0.3, 1, 0.2>), 0, 0), str(inside(D, y*3), 2, 0), "\n")
// expect: -0.500,-0.000,-0.933 0.500,2.000,0.933
// expect: 1 0
// expect: -1.000,-1.000,-1.000 1.000,1.000,1.000
// expect: 1 0
