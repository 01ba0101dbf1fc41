// Procedural textures: granite, marble, wood, bumps
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -7> look_at <0, 0.6, 0> angle 45 }
light_source { <5, 8, -6>, rgb 1 }
plane { y, 0 pigment { granite scale 2 color_map { [0 rgb <0.2, 0.2, 0.25>] [0.6 rgb <0.7, 0.6, 0.6>] [1 rgb 1] } } }
sphere { <-2.2, 1, 0>, 1 pigment { marble turbulence 1 octaves 6 color_map { [0 rgb 1] [0.7 rgb <0.5, 0.4, 0.5>] [1 rgb 0.1] } scale 0.4 } }
sphere { <0, 1, 0>, 1 pigment { wood turbulence 0.1 color_map { [0 rgb <0.6, 0.35, 0.2>] [1 rgb <0.35, 0.2, 0.1>] } scale 0.2 rotate 30*x } normal { bumps 0.4 scale 0.1 } finish { phong 0.6 } }
sphere { <2.2, 1, 0>, 1 pigment { agate scale 0.6 color_map { [0 rgb <0.9, 0.8, 0.3>] [1 rgb <0.6, 0.1, 0.1>] } } normal { crackle 0.5 scale 0.2 } finish { specular 0.6 } }
