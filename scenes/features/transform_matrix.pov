// Matrix, declared transform and its inverse
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
#declare Twist = transform { rotate <0, 30, 20> scale <1.5, 0.8, 1> translate <0.2, 0.4, 0> }
#declare Brick = box { <-0.4, 0, -0.3>, <0.4, 0.5, 0.3> pigment { checker rgb <0.8, 0.3, 0.2> rgb <0.9, 0.8, 0.2> scale 0.2 } }
object { Brick matrix <0.8, 0.3, 0, -0.4, 1, 0.1, 0, 0.2, 1, -1, 0.1, 0> }
object { Brick transform { Twist } translate <0.7, 0.3, 0.5> }
object { Brick transform { Twist inverse } translate <0.8, 0.5, -1> }
object { Brick transform { scale 0.5 rotate 30*y inverse } scale 0.3 translate <-0.2, 0, -1.4> }
