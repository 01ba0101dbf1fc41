// Transforms before and after the texture, and inside it
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
#declare Rings = pigment { onion color_map { [0.5 rgb <0.8, 0.3, 0.2>] [0.5 rgb <0.9, 0.9, 0.8>] } scale 0.3 }
box { -0.4, 0.4 pigment { Rings } scale <1, 1.6, 1> rotate 30*y translate <-1.1, 0.7, 0> }
box { -0.4, 0.4 scale <1, 1.6, 1> rotate 30*y translate <0, 0.7, 0> pigment { Rings } }
box { -0.4, 0.4 scale <1, 1.6, 1> pigment { Rings rotate <45, 20, 0> translate <0.2, 0.3, 0> } rotate 30*y translate <1.1, 0.7, 0> }
