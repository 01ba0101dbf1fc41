// Repeated black holes that reach beyond their blocks.
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> right x*8 up y*6 }
#declare Tile = box { <-1.9, -1.4, 0>, <1.9, 1.4, 1> }
#declare Stripes =
  pigment { gradient x color_map { [0 rgb 0] [0.5 rgb <1, 0.5, 0>] [1 rgb <0, 0.3, 1>] } scale 0.2 }
#default { finish { ambient 1 diffuse 0 } }
object { Tile pigment { Stripes warp { black_hole <0.1, 0.1, -0.3>, 0.4 strength 0.9 repeat <0.5, 0.5, 0.5> } } translate <-2, 1.5, 0> }
object { Tile pigment { Stripes warp { black_hole <0.5, 0.5, 0.5>, 0.5 repeat <0.9, 0.9, 0> } } translate <2, 1.5, 0> }
object { Tile pigment { Stripes warp { black_hole <0.5, 0.4, 0.2>, 0.4 repeat <1, 1, 1> turbulence 0.3 } } translate <-2, -1.5, 0> }
object { Tile pigment { Stripes warp { black_hole <0.1, 0.1, 0>, 0.4 inverse repeat <1, 1, 0> turbulence <0.5, 0, 0> } } translate <2, -1.5, 0> }
