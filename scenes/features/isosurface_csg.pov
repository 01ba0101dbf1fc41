// Isosurfaces in CSG, open, scaled, of noise, patterns and internal functions
// class: exact
#version 3.7;
#include "functions.inc"
global_settings { assumed_gamma 1 }

camera { location <0.4, 2.3, -4.6> look_at <0.05, 0.3, 0> angle 44 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, -0.4 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
difference {
  box { -0.55, 0.55 pigment { rgb <0.8, 0.3, 0.2> } }
  isosurface {
    function { f_torus(x, y, z, 0.4, 0.2) - f_noise3d(x*7, y*7, z*7)*0.1 }
    contained_by { box { -0.8, 0.8 } } max_gradient 2 all_intersections
    rotate 40*x translate <0.1, 0.4, -0.4> pigment { rgb <0.9, 0.8, 0.4> }
  }
  rotate 20*y translate <-1.2, 0.15, 0>
}
isosurface {
  function { f_superellipsoid(x, y, z, 0.4, 0.6) }
  threshold 0 contained_by { sphere { 0, 1.2 } } max_gradient 3
  scale <0.5, -0.4, 0.5> translate 0.3*y pigment { rgb <0.3, 0.7, 0.4> } finish { phong 0.6 }
}
#declare Cells = function { pattern { onion sine_wave scale 0.3 } }
isosurface {
  function { Cells(x, y, z) - 0.5 }
  contained_by { sphere { 0, 0.55 } } max_gradient 12 open max_trace 3
  rotate 30*x translate <1.2, 0.2, 0> pigment { rgb <0.3, 0.5, 0.9> }
}
