// Tori seen along their axes, but for the rounding of a turn
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z up 2.4*y right 3.2*x look_at 0 }
background { rgb 0.8 }
light_source { <-5, 8, -20>, rgb 1 }
torus { 0.8, 0.15 rotate 90*x pigment { rgb <0.8, 0.3, 0.2> } }
torus { 0.35, 0.1 rotate -90*x translate 0.2*x pigment { rgb <0.2, 0.4, 0.8> } }
torus { 0.3, 0.12 rotate <90, 180, 90> translate <-1.2, 0.7, 1> pigment { rgb <0.2, 0.7, 0.3> } }
