// An isosurface in a sphere and one in a box
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
isosurface {
  function { sin(5*x) + sin(5*y) + sin(5*z) }
  contained_by { sphere { 0, 0.8 } } threshold 0.1 max_gradient 9
  translate <-0.8, 0.8, 0> pigment { rgb <0.8, 0.3, 0.2> }
}
isosurface {
  function { x*x + y*y*y - z + 0.1*cos(12*x) }
  contained_by { box { -0.6, 0.6 } } max_gradient 4 open
  translate <0.8, 0.6, -0.2> pigment { rgb <0.2, 0.5, 0.8> }
}
