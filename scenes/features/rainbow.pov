// A rainbow in front of the sky
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at <0, 2, 0> angle 80 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.4, 0.5, 0.6> }
rainbow {
  direction <-0.2, -0.2, 1> angle 35 width 6 distance 100 arc_angle 150 falloff_angle 60
  color_map { [0 rgbt <1, 0.3, 1, 0.9>] [0.3 rgbt <0.2, 0.3, 1, 0.5>] [0.6 rgbt <0.3, 1, 0.3, 0.5>] [0.8 rgbt <1, 1, 0.2, 0.5>] [1 rgbt <1, 0.1, 0.1, 0.9>] }
}
plane { y, 0 pigment { rgb <0.3, 0.5, 0.2> } }
