// What a rainbow takes over from a declared one: all but its angles
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at <0, 2, 0> angle 80 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.4, 0.5, 0.6> }
#declare Colors = color_map { [0 rgbt <1, 0.3, 1, 0.7>] [0.5 rgbt <0.3, 1, 0.3, 0.3>] [1 rgbt <1, 0.1, 0.1, 0.6>] }
#declare Bow = rainbow { direction <-0.2, -0.2, 1> angle 35 width 12 distance 60 color_map { Colors } arc_angle 160 falloff_angle 20 }
rainbow { Bow angle 35 width 8 color_map { Colors } }
rainbow { Bow width 30 color_map { Colors } }
plane { y, 0 pigment { rgb <0.3, 0.5, 0.2> } }
