// An area light of no samples
// error: 4:46
#version 3.7;
light_source { <0, 5, 0>, 1 area_light x, z, 0, 4 }
