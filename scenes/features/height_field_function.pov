// Height fields from functions: an expression, a pattern, a pigment
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0.1, 2.6, -3.6> look_at <0, 0.1, 0> angle 42 }
light_source { <-5, 6, -3>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
#declare Waves = function(x, y, z) { 0.5 + 0.3*sin(9*x)*cos(7*y) }
height_field { function 40, 30 { Waves(x, y, z) } translate <-1.6, 0, -0.5> pigment { rgb <0.8, 0.4, 0.3> } }
height_field {
  function 30, 30 { pattern { bozo scale 0.25 } } smooth
  translate <-0.5, 0, -0.5> pigment { rgb <0.4, 0.7, 0.3> } finish { phong 0.4 }
}
height_field {
  function 24, 36 { pigment { onion color_map { [0 rgb <0.9, 0.1, 0.2>] [1 rgb <0.1, 0.8, 0>] } scale 0.4 } }
  water_level 0.2 translate <0.6, 0, -0.5> pigment { rgb <0.3, 0.5, 0.9> }
}
