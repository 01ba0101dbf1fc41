// What fractals show inside and outside, with other exponents
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 0, -5> look_at 0 angle 48 }
#declare Flat = finish { ambient 1 diffuse 0 }
#declare Colors = color_map { [0 rgb <0.1, 0.1, 0.3>] [0.3 rgb <0.8, 0.4, 0.2>] [0.9 rgb <1, 0.9, 0.6>] [1 rgb 0] }
#macro Tile(Column, Row, Pigment)
  box { <-0.95, -0.95, 0>, <0.95, 0.95, 0.1> texture { pigment { Pigment } finish { Flat } } translate <2 * Column, 2 * Row, 0> }
#end
Tile(-1, 0.5, pigment { mandel 30 exterior 2, 0.2 interior 1, 2 color_map { Colors } scale 0.7 translate 0.3*x })
Tile(0, 0.5, pigment { julia <0.3, 0.6>, 40 exponent 4 interior 6, 0.5 color_map { Colors } scale 0.7 })
Tile(1, 0.5, pigment { magnet 2 mandel 25 exterior 1, 1 interior 3, 0.5 color_map { Colors } scale 0.3 translate -0.5*x })
Tile(-1, -0.5, pigment { magnet 1 julia <1.2, 0.3>, 25 interior 1, 1 color_map { Colors } scale 0.3 })
Tile(0, -0.5, pigment { julia <-0.75, 0.11>, 30 exponent 3 exterior 6, 0.1 turbulence 0.1 scale 0.8 })
Tile(1, -0.5, pigment { mandel 20 exponent 5 exterior 4, 0.1 frequency 2 sine_wave scale 0.7 })
