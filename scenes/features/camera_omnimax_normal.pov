// A bumpy lens before an omnimax camera
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { omnimax location <0, 1, -3> look_at <0, 1.5, 0> normal { bumps 0.3 scale 0.3 } }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb 0.8 rgb 0.4 } }
