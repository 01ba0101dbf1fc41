// Values of functions and slopes outside 0 to 1 are folded before frequency and wave.
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> right x*8 up y*6 }
#default { finish { ambient 1 diffuse 0 } }
#declare Wide = color_map { [-1 rgb x] [0 rgb 0] [1 rgb <1, 0.9, 0.5>] [2 rgb z] }
#declare Strip = box { <-3.9, -0.2, 0>, <3.9, 0.2, 1> }
object { Strip pigment { function { x } color_map { Wide } } translate y*2.75 }
object { Strip pigment { function { x } color_map { Wide } frequency 0 } translate y*2.25 }
object { Strip pigment { function { x } color_map { Wide } frequency 2.5 phase 0.3 } translate y*1.75 }
object { Strip pigment { function { x } color_map { Wide } frequency 0 poly_wave 2 } translate y*1.25 }
object { Strip pigment { slope { -z altitude x } color_map { Wide } } translate y*0.75 }
object { Strip pigment { slope { -z altitude x } color_map { Wide } frequency 0 } translate y*0.25 }
object { Strip pigment { slope { -z altitude x } color_map { Wide } frequency 2.5 phase 0.3 } translate y*-0.25 }
object { Strip pigment { slope { -z altitude x, -0.5, 0.7 } color_map { Wide } frequency -1.5 phase -0.2 } translate y*-0.75 }
object { Strip pigment { slope { -z altitude x } color_map { Wide } frequency 0 cubic_wave } translate y*-1.25 }
object { Strip pigment { function { x*y*5 } color_map { Wide } frequency 1.5 sine_wave } translate y*-1.75 }
