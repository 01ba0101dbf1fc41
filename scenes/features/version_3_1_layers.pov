// Before version 3.5 filter of an upper layer counts as transmit, but not that of an image_map; later versions leave it
// class: exact
#version 3.1;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -8> look_at <0, 0.5, 0> angle 45 }
light_source { <-5, 10, -8> color rgb 1 }
plane { y, 0 pigment { checker color rgb 0.4 color rgb 0.9 } }
#declare Below = texture { pigment { gradient y color_map { [0 color rgb <0.9, 0.5, 0.2>] [1 color rgb <0.2, 0.5, 0.9>] } } }
#declare Old = texture { Below } texture { pigment { color rgbf <0.9, 0.3, 0.3, 0.7> } }
sphere { <-2.4, 1, 0>, 1 texture { Old } }
sphere { <0, 1, 0>, 1
  texture { Below }
  texture { pigment { image_map { png "images/flag.png" filter all 0.7 } } }
}
#version 3.6;
sphere { <2.4, 1, 0>, 1 texture { Below } texture { pigment { bozo color_map { [0 rgbf <0.9, 0.3, 0.3, 0.7>] [1 rgbf <0.3, 0.9, 0.3, 0.7>] } scale 0.3 } } }
