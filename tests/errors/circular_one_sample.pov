// A circular light with one sample per axis
// error: 4:51 circular
#version 3.7;
light_source { <0, 5, 0>, 1 area_light x, z, 1, 1 circular }
