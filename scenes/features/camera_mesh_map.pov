// A mesh_camera that follows the uv coordinates of a mesh: what its faces see
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera {
  mesh_camera { 1 3
    mesh {
      triangle { <-2, -1, -3>, <-2, 2, -3>, <2, -1, -3> uv_vectors <0.1, 0.1>, <0.1, 0.95>, <0.9, 0.1> }
      triangle { <2, -1, -3>, <-2, 2, -3>, <2, 2, -3.5> uv_vectors <0.9, 0.1>, <0.1, 0.95>, <0.8, 0.8> }
    }
  }
  location <0, 0, 0.01>
}
light_source { <2, 4, -3>, rgb 1 }
background { rgb <0.2, 0.3, 0.5> }
plane { y, -1 pigment { checker rgb 0.9 rgb <0.3, 0.4, 0.5> } }
sphere { <0.8, 0, 1>, 1 pigment { rgb <0.9, 0.3, 0.2> } }
box { -0.6, 0.6 rotate 30*y translate <-1.2, -0.4, 1.6> pigment { rgb <0.2, 0.6, 0.4> } }
