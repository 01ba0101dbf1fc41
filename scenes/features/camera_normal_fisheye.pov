// A normal perturbs the rays of a fisheye camera
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { fisheye location <0.5, 1.2, -1.6> look_at <0, 0.6, 0> angle 120 normal { granite 0.2 scale 0.5 } }
light_source { <-1.5, 2.5, -3>, rgb 1 }
light_source { <3, 2, -1>, rgb 0.3 shadowless }
box { <-4, 0, -5>, <4, 3, 4> pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.3, 0.45, 0.6> scale 0.5 translate 0.01 } }
sphere { <-0.5, 0.6, 0.5>, 0.4 pigment { rgb <0.8, 0.4, 0.3> } finish { phong 0.6 } }
