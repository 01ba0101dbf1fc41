// Bumps inside an object, others outside
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Shown = normal { object{sphere{0,0.6 inverse} normal{bumps 1 scale .2} normal{wrinkles}} }

camera { location <1.3, 2.2, -5.2> look_at <0.15, -0.05, 0> angle 42 }
light_source { <-6, 5, -6>, rgb 1 }
light_source { <9, 2, -4>, rgb <0.25, 0.2, 0.15> }
background { rgb <0.25, 0.32, 0.45> }
#declare Bumpy = texture { pigment { rgb <0.85, 0.7, 0.5> } normal { Shown } finish { phong 0.5 phong_size 30 } }
box { <-1.1, -1.3, -0.5>, <0.9, 1.2, 0.7> texture { Bumpy } rotate <8, 28, 4> translate <-0.75, 0, 0> }
sphere { 0, 0.95 texture { Bumpy } rotate <20, -35, 15> translate <1.25, -0.2, 0> }
