// Negative amounts behind functions, files and slopes.
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> right x*6 up y*4.5 }
light_source { <-10, 20, -30>, rgb 1 }
#default { pigment { rgb 0.9 } finish { specular 0.4 } }
#declare Deep = 0.6;
sphere { 0, 0.9 normal { function { sin(x*5)*y } -0.5 scale 0.5 } translate <-2, 1.1, 0> }
sphere { 0, 0.9 normal { function { sin(x*5)*y } -Deep*2 + 0.4 scale 0.5 } translate <0, 1.1, 0> }
sphere { 0, 0.9 normal { slope y 0.4 } translate <2, 1.1, 0> }
sphere { 0, 0.9 normal { density_file df3 "images/cloud.df3" -Deep translate -0.5 scale 1.6 } translate <-2, -1.1, 0> }
sphere { 0, 0.9 normal { function { sin(x*5)*y } +Deep scale 0.5 } translate <0, -1.1, 0> }
sphere { 0, 0.9 normal { slope { y, 0.2, 0.8 } -0.4 } translate <2, -1.1, 0> }
