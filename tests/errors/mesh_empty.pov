// A mesh without triangles
// error: 4:8 mesh
#version 3.7;
mesh { }
