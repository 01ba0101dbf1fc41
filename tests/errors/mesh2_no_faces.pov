// A mesh2 without faces
// error: 4:9 face_indices
#version 3.7;
mesh2 { vertex_vectors { 3, 0, x, y } }
