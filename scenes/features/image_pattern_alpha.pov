// The transparency of a picture as a pattern, and a grey picture repeated and shifted
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 0, -5> look_at 0 angle 40 }
background { rgb <0.25, 0.32, 0.45> }
#declare Flat = finish { ambient 1 diffuse 0 }
box { <-1.9, -1.2, 0>, <-0.1, 1.2, 0.1>
  pigment { image_pattern { png "images/badge.png" use_alpha interpolate 2 } color_map { [0 rgb <0.9, 0.2, 0.1>] [1 rgb <0, 0.3, 0.6>] } translate <0.11, 0.07, 0> scale 1.7 }
  finish { Flat } }
box { <0.1, -1.2, 0>, <1.9, 1.2, 0.1>
  pigment { image_pattern { png "images/hills.png" interpolate 3 repeat <2, 3> offset <0.3, 0.2> } frequency 2 triangle_wave scale 1.7 }
  finish { Flat } }
