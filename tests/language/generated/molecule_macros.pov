// Molecules as a viewer writes them: a comma missing among the parameters, finishes as strings of items
#version 3.6;
#include "colors.inc"
#include "finish.inc"
global_settings { assumed_gamma 2.2 max_trace_level 6 }
background { color White transmit 1.0 }
camera { orthographic
  right -15.00*x up 12.00*y
  direction 50.00*z
  location <0,0,50.00> look_at <0,0,0> }
light_source { <2.00, 3.00, 40.00> color White
  area_light <0.70, 0, 0>, <0, 0.70, 0>, 3, 3
  adaptive 1 jitter }
#declare simple = finish { phong 0.7 };
#declare ase3 = finish { ambient 0.15 brilliance 2 diffuse 0.6 metallic specular 1. roughness 0.001 reflection 0.0 };
#declare Rcell = 0.050;
#declare Count = 0;
#macro atom(LOC, R, COL, TRANS, FIN)
  #declare Count = Count + 1;
  sphere { LOC, R texture { pigment { color COL transmit TRANS } finish { FIN } } }
#end
#macro constrain(LOC, R, COL, TRANS FIN)
union { torus { R, Rcell rotate 45*z texture { pigment { color COL transmit TRANS } finish { FIN } } }
        torus { R, Rcell rotate -45*z texture { pigment { color COL transmit TRANS } finish { FIN } } }
        translate LOC }
#end
cylinder { < -5.65, -3.27, -9.99>, < 5.65, -3.27, -9.99>, Rcell pigment { Black } }
atom(< -1.43, 0.05, -0.25>, 0.66, color rgb < 0.50, 0.50, 0.50>, 0.0, ase3) // #0
atom(<  1.43, 0.05, -0.25>, 0.31, color rgb <1.00, 1.00, 1.00>, 0.25, simple) // #1
constrain(<0,0,0>, 1.2, Black, 0.0 ase3)
cylinder { < -1.43, 0.05, -0.25>, <1.43, 0.05, -0.25>, 0.10 texture { pigment { color rgb <1,0,0> transmit 0.0 } finish { ase3 } } }
#debug concat(str(Count, 0, 0), "\n") // expect: 2
