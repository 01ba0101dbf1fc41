// Meshes made by macros: a lathe, a prism and a surface over two variables
#version 3.7;
global_settings { assumed_gamma 1 }
#include "meshmaker.inc"
#declare Outline = spline { linear_spline 0, <1, 0, 0>, 0.5, <0.5, 1, 0>, 1, <1, 2, 0> }
#declare Turned = object { Lathe(Outline, 6, 360, 8, "") }
#debug concat(vstr(3, min_extent(Turned), ",", 0, 4), " ", vstr(3, max_extent(Turned), ",", 0, 4), "\n")
#declare Ring = spline { cubic_spline -0.25, <0, 0, -1>, 0, <1, 0, 0>, 0.25, <0, 0, 1>, 0.5, <-1, 0, 0>, 0.75, <0, 0, -1>, 1, <1, 0, 0>, 1.25, <0, 0, 1> }
#declare Pushed = object { Prism(Ring, 8, 2, 3, "") }
#debug concat(vstr(3, max_extent(Pushed), ",", 0, 4), "\n")
#declare Hit = trace(Turned, <0, 1, -5>, z);
#debug concat(vstr(3, Hit, ",", 0, 4), "\n")
// expect:
// expect:  Calculating 63 vertices for 96 triangles
// expect:
// expect:
// expect:  Done 7 vertices : 11.11 %
// expect:  Done 14 vertices : 22.22 %
// expect:  Done 21 vertices : 33.33 %
// expect:  Done 28 vertices : 44.44 %
// expect:  Done 35 vertices : 55.56 %
// expect:  Done 42 vertices : 66.67 %
// expect:  Done 49 vertices : 77.78 %
// expect:  Done 56 vertices : 88.89 %
// expect:  Done 63 vertices : 100.00 %
// expect:
// expect:  Building mesh2:
// expect:    - vertex_vectors
// expect:    - normal_vectors
// expect:    - uv_vectors
// expect:    - face_indices
// expect: -1.0000,0.0000,-1.0000 1.0000,2.0000,1.0000
// expect:
// expect:  Calculating 36 vertices for 48 triangles
// expect:
// expect:
// expect:  Done 9 vertices : 25.00 %
// expect:  Done 18 vertices : 50.00 %
// expect:  Done 27 vertices : 75.00 %
// expect:  Done 36 vertices : 100.00 %
// expect:
// expect:  Building mesh2:
// expect:    - vertex_vectors
// expect:    - normal_vectors
// expect:    - uv_vectors
// expect:    - face_indices
// expect: 1.0000,2.0000,1.0000
// expect: 0.0000,1.0000,-0.5000
