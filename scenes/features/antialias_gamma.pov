// Antialiasing decided at another gamma
// class: exact
// switches: +A0.2 +AM2 +R2 -J Antialias_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.75> rgb <0.2, 0.3, 0.35> scale 0.2 } }
sphere { <-0.7, 0.7, 0>, 0.7 pigment { radial color_map { [0.5 rgb <0.8, 0.3, 0.2>] [0.5 rgb <0.95, 0.9, 0.8>] } frequency 20 } finish { phong 0.9 phong_size 150 } }
#for (I, 0, 9) cylinder { <0.3 + I*0.12, 0, -0.3>, <0.5 + I*0.1, 1.4, 0.2>, 0.02 pigment { rgb <0.2, 0.5, 0.8> } } #end
torus { 0.4, 0.03 rotate 20*x translate <0.2, 0.1, -1.3> pigment { rgb <0.9, 0.8, 0.2> } }
