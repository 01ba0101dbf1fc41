// A normal perturbs the camera's rays
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 normal { bumps 0.3 scale 0.1 } }
light_source { <-1.5, 2.5, -3>, rgb 1 }
light_source { <3, 2, -1>, rgb 0.3 shadowless }
box { <-4, 0, -5>, <4, 3, 4> pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.3, 0.45, 0.6> scale 0.5 translate 0.01 } }
sphere { <-0.8, 0.5, 0.2>, 0.5 pigment { rgb <0.8, 0.3, 0.2> } finish { phong 0.6 } }
box { <0.3, 0, -0.4>, <1, 1, 0.4> pigment { rgb <0.2, 0.5, 0.8> } }
cone { <0, 0, -0.9>, 0.3, <0, 0.6, -0.9>, 0.1 pigment { rgb <0.9, 0.8, 0.2> } }
