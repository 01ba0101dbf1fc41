// Textures on surface coordinates do not move with the object, others do
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <1.4, 2.2, -5.2> look_at <0.1, 0, 0> angle 42 }
light_source { <-6, 5, -6>, rgb 1 }
background { rgb <0.25, 0.32, 0.45> }
#declare Stripes = pigment { gradient x color_map { [0.5 rgb <0.8, 0.3, 0.2>] [0.5 rgb <0.9, 0.85, 0.6>] } scale 0.1 }
sphere { 0, 0.7 pigment { uv_mapping Stripes } rotate <20, 30, 40> translate <-1.3, 0.7, 0> }
sphere { 0, 0.7 uv_mapping texture { pigment { Stripes } rotate 30*z } rotate <20, 30, 40> translate <0, -0.8, 0> }
union {
  sphere { 0, 0.7 texture { uv_mapping pigment { Stripes } rotate 40*z } translate <1.3, 0.7, 0> }
  sphere { 0, 0.4 uv_mapping translate <-1.3, -0.7, -0.2> }
  pigment { Stripes }
  rotate 15*z
}
