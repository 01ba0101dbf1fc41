// Equal entries at the end of a map: the last counts, elsewhere the first
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 0, -5> look_at 0 angle 40 }
#declare Flat = finish { ambient 1 diffuse 0 }
box { <-1.7, -1, 0>, <-0.1, 1, 0.1>
  pigment { checker pigment { boxed translate 5 color_map { [0 rgb <1, 0, 0>] [1 rgb <0, 1, 0>] } }
            pigment { planar scale <1, 1000000, 1> color_map { [0 rgb 0] [1 rgb <0, 0.5, 1>] [1 rgb <1, 0.5, 0>] } } scale 0.4 }
  finish { Flat } }
box { <0.1, -1, 0>, <1.7, 1, 0.1> pigment { mandel 50 color_map { [0 rgb 0] [0.3 rgb <0.5, 0, 0>] [1 rgb <1, 1, 0>] [1 rgb <0, 0.2, 0.5>] } scale 0.7 translate 0.9*x } finish { Flat } }
