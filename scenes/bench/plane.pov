// Next to nothing: what a pixel costs
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -5> look_at <0, 0, 2> }
light_source { <5, 8, -6>, rgb 1 }
plane { y, 0 pigment { rgb <0.8, 0.5, 0.3> } }
sphere { <0, 0.5, 0>, 0.5 pigment { rgb 0.7 } }
