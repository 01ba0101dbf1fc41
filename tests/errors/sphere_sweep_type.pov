// A sphere sweep without its kind of spline
// error: 4:16
#version 3.7;
sphere_sweep { 3, 0, 1, x, 1, y, 1 }
