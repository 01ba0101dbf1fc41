// point_at on a point light
// error: 4:29
#version 3.7;
light_source { <0, 5, 0>, 1 point_at 0 }
