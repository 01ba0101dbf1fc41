// A tiling
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Shown = texture { pigment { tiling 7 color_map { [0 rgb <0.1, 0.1, 0.3>] [0.3 rgb <0.8, 0.4, 0.2>] [1 rgb <1, 0.9, 0.6>] } scale 0.3 rotate 90*x } }

camera { location <1.3, 1.9, -5.2> look_at <0.15, 0, 0> angle 42 }
light_source { <-4, 7, -8>, rgb 1 }
light_source { <9, 2, -4>, rgb <0.25, 0.2, 0.15> }
background { rgb <0.25, 0.32, 0.45> }
box { <-1.1, -1.3, -0.5>, <0.9, 1.2, 0.7> texture { Shown } rotate <8, 28, 4> translate <-0.75, 0, 0> }
sphere { 0, 0.95 texture { Shown } rotate <20, -35, 15> translate <1.25, -0.2, 0> }
