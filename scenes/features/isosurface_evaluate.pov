// Isosurfaces whose gradient is estimated (evaluate), with a threshold and a low accuracy
// class: close — POV-Ray learns the gradient from ray to ray
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
isosurface {
  function { sin(7*x) + sin(7*y) + sin(7*z) }
  contained_by { sphere { 0, 0.7 } } threshold 0.3 evaluate 1, 1.2, 0.95
  translate <-0.8, 0.75, 0> pigment { rgb <0.8, 0.3, 0.2> }
}
isosurface {
  function { pow(x, 4) + pow(y, 4) + pow(z, 4) }
  contained_by { box { -0.7, 0.7 } } threshold 0.1 accuracy 0.02 evaluate 2, 1.4, 0.7
  rotate <20, 30, 0> translate <0.8, 0.7, -0.2> pigment { rgb <0.2, 0.5, 0.8> }
}
