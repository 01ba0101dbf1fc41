// A height field from a POT file, whose halves hold the high and the low bytes
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.5, 1.1, -1.2> look_at <0.5, 0.1, 0.45> angle 45 }
light_source { <-3, 4, -3>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
height_field { pot "mtmand.pot" smooth scale <1, 0.4, 1> pigment { rgb <0.7, 0.6, 0.5> } }
