// Absorbing media in two boxes
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
box { <-1.4, 0, -0.4>, <-0.3, 1.3, 0.4> pigment { rgbt 1 } hollow interior { media { absorption rgb <0.3, 1.2, 2> } } }
sphere { 0, 0.7 pigment { rgbt 1 } hollow interior { media { absorption rgb <2, 1, 0.2> density { gradient y color_map { [0 rgb 2] [1 rgb 0.2] } } } } translate <0.8, 0.8, 0> }
