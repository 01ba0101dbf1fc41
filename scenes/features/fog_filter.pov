// Fog with filter and transmit lets the far side through
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.9, 0> angle 60 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.2, 0.4, 0.8> }
fog { distance 5 rgbft <0.9, 0.6, 0.4, 0.4, 0.2> }
plane { y, 0 pigment { checker rgb <0.8, 0.4, 0.3> rgb <0.3, 0.35, 0.4> } }
#for (I, 0, 7) cylinder { <1.5 - I*0.9, 0, I*1.5>, <1.5 - I*0.9, 2, I*1.5>, 0.3 pigment { rgb <0.9, 0.7, 0.1> } } #end
