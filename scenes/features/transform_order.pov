// The order of rotate, scale and translate matters
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
#declare Brick = box { <-0.5, 0, -0.2>, <0.5, 0.3, 0.2> pigment { gradient x color_map { [0 rgb <0.8, 0.3, 0.2>] [1 rgb <0.9, 0.8, 0.2>] } scale 0.3 } }
object { Brick rotate 40*z translate <-0.9, 0.6, 0> }
object { Brick translate <-0.9, 0.6, 0> rotate -40*z scale <1, 1.5, 1> }
object { Brick scale <0.5, 3, 1> rotate <20, 30, 40> translate <0.9, 0.1, 0> }
object { Brick translate <0.3, 0, -1.2> scale <1, 0.5, 1> rotate 10*y }
