// Lights inside a union move with it
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 45 }
union {
  light_source { <0, 1, -0.5>, rgb <1, 0.8, 0.6> }
  sphere { <0.8, 0.5, 0>, 0.4 pigment { rgb <0.8, 0.3, 0.2> } }
  rotate 150*y translate <0, 1, -0.8>
}
plane { y, 0 pigment { rgb <0.75, 0.72, 0.66> } }
box { <-0.2, 0, 0>, <0.4, 0.8, 0.6> pigment { rgb <0.2, 0.5, 0.8> } }
