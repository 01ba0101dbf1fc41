// Text: kerning, offsets, two fonts, interior texture
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.5, 2.3, -6> look_at <2.2, 0.7, 0> angle 50 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
text { ttf "timrom.ttf" "Rajaj AV To" 0.2, <0,0.05,0.2>  pigment { rgb <0.8, 0.3, 0.2> } translate y*1.5}
text { ttf "cyrvetic.ttf" "To be 8 Yo" 0.2, <-0.1,0,0>  pigment { rgb <0.2, 0.8, 0.2> } interior_texture{pigment{rgb <1,1,0>}} translate -y*.5 }
