// Normals on different sides of a smooth triangle
// warning: 4:19 triangle
#version 3.7;
smooth_triangle { 0, z, x, -z, y, z }
