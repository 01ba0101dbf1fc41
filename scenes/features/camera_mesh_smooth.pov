// A mesh_camera that follows uv coordinates, with smooth normals and a stretched mesh
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Lens = mesh2 {
  vertex_vectors { 4, <-1, -1, -4>, <-1, 1, -4>, <1, -1, -4>, <1, 1, -4.5> }
  normal_vectors { 4, <-0.4, -0.3, 1>, <-0.4, 0.3, 1>, <0.4, -0.3, 1>, <0.3, 0.3, 1> }
  uv_vectors { 4, <0, 0>, <0, 1>, <1, 0>, <1, 1> }
  face_indices { 2, <0, 2, 1>, <2, 3, 1> }
  normal_indices { 2, <0, 2, 1>, <2, 3, 1> }
  uv_indices { 2, <0, 2, 1>, <2, 3, 1> }
}
camera {
  mesh_camera { 1 3
    mesh { Lens scale <1, 1.5, 1> rotate 10*z }
    smooth
  }
  location <0, 0, 1>
}
light_source { <2, 4, -3>, rgb 1 }
background { rgb <0.2, 0.3, 0.5> }
plane { y, -1 pigment { checker rgb 0.9 rgb <0.3, 0.4, 0.5> } }
sphere { <0.8, 0, 1>, 1 pigment { rgb <0.9, 0.3, 0.2> } }
box { -0.6, 0.6 rotate 30*y translate <-1.2, -0.4, 1.6> pigment { rgb <0.2, 0.6, 0.4> } }
