// Colours given as srgb
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Warm = srgb <0.9, 0.5, 0.2>;
camera { location <0, 0, -5> look_at 0 angle 45 }
background { srgb 0.31 }
light_source { <-5, 8, -7>, srgb <1, 0.9, 0.8> }
sphere { <-1, 0, 0>, 0.8 pigment { color Warm } }
box { <0.2, -0.8, 0>, <1.8, 0.8, 0.1> pigment { gradient x color_map { [0 srgb <0.1, 0.2, 0.6>] [1 srgbt <0.9, 0.9, 0.4, 0.5>] } scale 2 } finish { ambient 1 diffuse 0 } }
