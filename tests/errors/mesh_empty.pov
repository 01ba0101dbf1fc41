// A mesh without triangles
// error: 4:1 mesh
#version 3.7;
mesh { }
