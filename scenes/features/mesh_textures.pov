// Triangles of a mesh with their own textures and one texture per corner
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
#declare Red = texture { pigment { rgb <0.9, 0.2, 0.1> } finish { phong 0.8 } }
#declare Blue = texture { pigment { rgb <0.1, 0.3, 0.9> } }
#declare Lime = texture { pigment { checker rgb <0.6, 0.9, 0.1> rgb <0.2, 0.4, 0.1> scale 0.2 } }
mesh {
  triangle { <-1.7, 0, 0>, <-0.4, 0, -0.6>, <-0.9, 1.5, 0.2> texture { Lime } }
  triangle { <-0.4, 0, -0.6>, <0.3, 1.6, 0.4>, <-0.9, 1.5, 0.2> texture { Red } }
  triangle { <-0.4, 0, -0.6>, <1.6, 0, -0.4>, <0.3, 1.6, 0.4> texture_list { Red Blue Lime } }
  texture { Blue }
}
