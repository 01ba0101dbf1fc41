// A parametric surface
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
parametric {
  function { cos(u)*(0.8 + 0.3*cos(v)) } function { 0.3*sin(v) + 0.1*u } function { sin(u)*(0.8 + 0.3*cos(v)) }
  <0, 0>, <5, 6.3> contained_by { box { <-1.2, -0.5, -1.2>, <1.2, 1, 1.2> } }
  max_gradient 1.2 accuracy 0.05 precompute 12, x, y, z
  translate 0.6*y pigment { rgb <0.8, 0.3, 0.2> } finish { phong 0.5 }
}
