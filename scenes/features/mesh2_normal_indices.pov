// A mesh2 that shares normals by index and leaves the last face flat
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
mesh2 {
  vertex_vectors { 5, <-1.4, 0, -0.7>, <0.5, 0, -0.9>, <1.4, 0.1, 0.6>, <-1.2, 0, 0.7>, <0, 1.6, 0> }
  normal_vectors { 3, <-1, 0.4, -1>, <1, 0.4, -1>, <0, 1, 0> }
  face_indices { 3, <0, 1, 4>, <1, 2, 4>, <3, 0, 4> }
  normal_indices { 2, <0, 1, 2>, <1, 1, 2> }
  pigment { rgb <0.3, 0.65, 0.35> } finish { phong 0.7 phong_size 25 }
}
