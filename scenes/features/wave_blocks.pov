// Waves and frequencies of block patterns mix the neighbours of their lists.
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> right x*8 up y*6 }
light_source { <-10, 20, -30>, rgb 1 }
#declare Tile = box { <-0.9, -0.9, 0>, <0.9, 0.9, 1> }
object { Tile pigment { checker rgb x, rgb y frequency 0.7 phase 0.1 scale 0.4 } translate <-3, 2, 0> }
object { Tile pigment { checker rgb x, rgb y sine_wave scale 0.4 } translate <-1, 2, 0> }
object { Tile pigment { hexagon rgb x, rgb y, rgb z frequency 0.5 rotate x*90 scale 0.3 } translate <1, 2, 0> }
object { Tile pigment { brick rgb x, rgb y frequency 0.4 phase 0.2 scale 0.1 } translate <3, 2, 0> }
object { Tile pigment { square rgb x, rgb y, rgb z, rgb 1 cubic_wave rotate x*90 scale 0.3 } translate <-3, 0, 0> }
object { Tile pigment { triangular rgb x, rgb y, rgb z, rgb 1, rgb 0, rgb <1, 1, 0> poly_wave 0.5 rotate x*90 scale 0.3 } translate <-1, 0, 0> }
object { Tile pigment { object { sphere { 0, 0.7 } rgb x, rgb y } frequency 0.6 } translate <1, 0, 0> }
object { Tile pigment { cubic rgb x, rgb y, rgb z, rgb 1, rgb 0, rgb <1, 1, 0> frequency 0.3 translate 0.1 } translate <3, 0, 0> }
object { Tile texture { checker texture { pigment { rgb x } }, texture { pigment { rgb 1 } finish { phong 1 } } frequency 0.6 scale 0.4 } translate <-3, -2, 0> }
object { Tile pigment { rgb 1 } normal { checker normal { bumps 0 }, normal { gradient x 0.8 } frequency 0.6 scale 0.4 } translate <-1, -2, 0> }
object { Tile pigment { checker rgb x, rgb y phase 0.4 scale 0.4 } translate <1, -2, 0> }
object { Tile pigment { quilted color_map { [0 rgb 0] [1 rgb <1, 0.8, 0.2>] } phase 0.4 scale 0.4 } translate <3, -2, 0> }
