// A face of a mesh that names a vertex it does not have
// error: 4:69 7
#version 3.7;
mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 7> } }
