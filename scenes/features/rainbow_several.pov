// Rainbows that overlap, with filter, fog and their image in a mirror
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at <0, 2, 0> angle 90 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.4, 0.5, 0.6> }
#declare Colors = color_map {
  [0 rgbft <1, 0.3, 1, 0.2, 0.7>] [0.3 rgbft <0.2, 0.3, 1, 0.5, 0.3>] [0.6 rgbft <0.3, 1, 0.3, 0.5, 0.3>] [1 rgbft <1, 0.1, 0.1, 0.4, 0.6>]
}
rainbow { direction <-0.2, -0.2, 1> angle 35 width 12 distance 60 color_map { Colors } arc_angle 200 falloff_angle 20 }
rainbow { direction <0.2, -0.2, 1> angle 32 width -12 distance 30 color_map { Colors } up <0.3, 1, 0> falloff_angle 40 }
rainbow { direction <0, 0, -1> angle 40 width 15 color_map { Colors } }
fog { distance 80 color rgbt <0.7, 0.7, 0.6, 0.5> }
plane { y, 0 pigment { checker rgb <0.3, 0.5, 0.2> rgb <0.5, 0.5, 0.2> } finish { reflection 0.3 } }
box { <-2, 0, 2>, <2, 2.5, 2.2> rotate 20*y pigment { rgb 0.1 } finish { reflection 0.8 } }
sphere { <2.5, 1, 0>, 1 pigment { rgbt <0.9, 0.9, 0.9, 0.8> } hollow finish { phong 0.5 } }
