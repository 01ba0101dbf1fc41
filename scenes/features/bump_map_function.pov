// Bumps and greys from functions sampled as images, without and with interpolation
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 0, -4> look_at 0 angle 42 }
light_source { <-5, 6, -7>, rgb 1 }
#declare Waves = function { 0.5 + 0.5*sin(20*x)*cos(15*y) }
box {
  <-1.3, -0.95, 0>, <-0.05, 0.95, 1>
  pigment { rgb <0.8, 0.7, 0.5> } normal { bump_map { function 50, 50 { Waves(x, y, z) } interpolate 2 bump_size 4 } }
}
box {
  <0.05, 0.05, 0>, <1.3, 0.95, 1>
  pigment { image_pattern { function 20, 10 { Waves(x, y, z) } } color_map { [0 rgb <0.1, 0.2, 0.5>] [1 rgb <1, 0.8, 0.4>] } }
}
box {
  <0.05, -0.95, 0>, <1.3, -0.05, 1>
  pigment { image_map { function 25, 15 { x*1.3 - y*0.4 } interpolate 2 } }
}
