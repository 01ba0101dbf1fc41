// GIF pictures: the rows of an interlaced one are shown in the order of the file.
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> right x*4 up y*3 }
#default { finish { ambient 1 diffuse 0 } }
plane { z, 2 pigment { checker rgb 0.2, rgb 0.8 scale 0.103 translate 0.01 } }
#declare Tile = box { 0, <1.8, 1.3, 1> }
object { Tile pigment { image_map { gif "images/tiles.gif" } } translate <-1.907, 0.113, 0> }
object { Tile pigment { image_map { gif "images/tiles_interlaced.gif" } } translate <0.103, 0.113, 0> }
object { Tile pigment { image_map { gif "images/tiles_interlaced.gif" transmit 2, 0.8 } } translate <-1.907, -1.411, 0> }
object { Tile pigment { image_map { bmp "images/flag.bmp" interpolate 2 } } translate <0.103, -1.411, 0> }
