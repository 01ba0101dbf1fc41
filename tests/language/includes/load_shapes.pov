// Shape libraries load
#version 3.7;
#include "shapes.inc"
#include "shapes2.inc"
#include "shapes_old.inc"
#include "shapesq.inc"
#include "functions.inc"
#debug concat(str(defined(Octahedron), 0, 6), "\n") // expect: 1.000000
#debug concat(str(defined(Cone_X), 0, 6), "\n") // expect: 1.000000
#debug concat(str(defined(f_sphere), 0, 6), "\n") // expect: 1.000000
#declare H = object { Hexagon }
#debug concat(vstr(3, max_extent(H), ",", 0, 6), "\n") // expect: 1.500000,1.500000,1.500000
