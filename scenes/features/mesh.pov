// A mesh of triangles, twice, with a transform
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
#declare Gem = mesh {
  triangle { <0, 1.4, 0>, <0.7, 0.5, 0>, <0, 0.5, -0.7> }
  triangle { <0, 1.4, 0>, <0, 0.5, -0.7>, <-0.7, 0.5, 0> }
  triangle { <0, 1.4, 0>, <-0.7, 0.5, 0>, <0, 0.5, 0.7> }
  triangle { <0, 1.4, 0>, <0, 0.5, 0.7>, <0.7, 0.5, 0> }
  triangle { <0, 0, 0>, <0.7, 0.5, 0>, <0, 0.5, -0.7> }
  triangle { <0, 0, 0>, <0, 0.5, -0.7>, <-0.7, 0.5, 0> }
  triangle { <0, 0, 0>, <-0.7, 0.5, 0>, <0, 0.5, 0.7> }
  triangle { <0, 0, 0>, <0, 0.5, 0.7>, <0.7, 0.5, 0> }
}
object { Gem translate -0.7*x pigment { rgb <0.8, 0.3, 0.2> } }
object { Gem rotate <0, 30, -50> scale <0.8, 1, 1.2> translate <0.4, 0.5, 0.3> pigment { rgb <0.2, 0.5, 0.8> } finish { phong 0.5 } }
