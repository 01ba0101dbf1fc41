// Metallic highlights take the colour of the pigment
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.5, 1.5, -5> look_at <0.1, 0.2, 0> angle 45 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <6, 2, 3>, rgb 0.9 }
background { rgb <0.2, 0.25, 0.3> }
sphere { <-1.6, 0.2, 0>, 0.5 pigment { rgb <0.9, 0.5, 0.1> } finish { specular 0.9 roughness 0.08 } }
sphere { <-0.5, 0.2, 0>, 0.5 pigment { rgb <0.9, 0.5, 0.1> } finish { specular 0.9 roughness 0.08 metallic } }
sphere { <0.6, 0.2, 0>, 0.5 pigment { rgb <0.9, 0.5, 0.1> } finish { phong 0.9 phong_size 12 metallic 0.5 } }
sphere { <1.7, 0.2, 0>, 0.5 pigment { rgb <0.9, 0.5, 0.1> } finish { phong 0.9 phong_size 12 metallic 2 } }
