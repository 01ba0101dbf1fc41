// An image map by the uv coordinates of a sphere and a box
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
sphere { 0, 0.75 uv_mapping pigment { image_map { png "images/flag.png" interpolate 2 } scale <0.5, 1, 1> } rotate <-20, 30, 0> translate <-0.8, 0.8, 0> }
box { <0.2, 0, -0.5>, <1.2, 1.1, 0.5> uv_mapping pigment { image_map { png "images/flag.png" } } rotate 10*y }
