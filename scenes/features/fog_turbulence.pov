// Fog with turbulence
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.9, 0> angle 60 }
light_source { <-5, 8, -7>, rgb 1 }
fog { distance 6 rgb <0.7, 0.75, 0.85> turbulence <0.6, 0.3, 0.5> turb_depth 0.8 octaves 4 omega 0.6 }
plane { y, 0 pigment { checker rgb <0.8, 0.4, 0.3> rgb <0.3, 0.35, 0.4> } }
#for (I, 0, 7) cylinder { <1.5 - I*0.9, 0, I*1.5>, <1.5 - I*0.9, 2, I*1.5>, 0.3 pigment { rgb <0.9, 0.7, 0.1> } } #end
