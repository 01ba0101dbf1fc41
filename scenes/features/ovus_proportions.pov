// Eggs of all proportions, cut and clear; tori that meet themselves
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.5, 2.3, -6> look_at <1.5, 0.7, 0> angle 60 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
ovus { 0.6, 0.3 translate <-1.5, 0.6, 0> pigment { rgb <0.8, 0.3, 0.2> } finish { phong 0.6 } }
ovus { 0.4, 0.35 rotate <40, 0, -50> translate <0.2, 0.6, -0.2> pigment { rgb <0.2, 0.5, 0.8> } finish { phong 0.6 } }
ovus { 0.3, 0.7 translate <1.5, 0.6, 0> pigment { rgb <0.2, 0.3, 0.8> } finish { phong 0.6 } }
ovus { 0.5, 0.7 translate <1.5, 2, 0> pigment { rgbt <0.2, 0.3, 0.8,.5> } finish { phong 0.6 } interior_texture{pigment{rgb y}}}
ovus { 0.5, 0.1 translate <-1.5, 2, 0> pigment { rgbt <0.2, 0.3, 0.8,.5> } finish { phong 0.6 } interior_texture{pigment{rgb y}}}
difference{ ovus { 0.8, 0.3} plane{z,0} translate <3.5, 1, 0> pigment { rgb <0.2, 0.8, 0.8> } finish { phong 0.6 } }
ovus { 0.5, 1.2 translate <3.5, -0.8, 0> pigment { rgbt <0.2, 0.3, 0.8,.5> } finish { phong 0.6 } interior_texture{pigment{rgb y}}}
torus { 0.5, 0.8 translate <.5, -0.8, 0> pigment { rgbt <0.2, 0.3, 0.8,.5> } finish { phong 0.6 } interior_texture{pigment{rgb y}}}
difference{torus { 0.5, 0.8 } box{0,3 translate -z*2} translate <-1.5, -0.8, 0> pigment { rgb <0.2, 0.3, 0.8> } finish { phong 0.6 } interior_texture{pigment{rgb y}}}
