// A negative right vector makes the coordinate system right-handed
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <3, -5, 2.4> sky z right <-4/3, 0, 0> up z look_at <0, 0, 0.5> angle 40 }
light_source { <6, -5, 8>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
plane { z, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.3, 0.45, 0.35> } }
box { <-1, -1, 0>, <0.4, 0.3, 1.5> pigment { rgb <0.8, 0.3, 0.2> } }
cylinder { <1.2, -0.5, 0>, <1.2, -0.5, 1.2>, 0.4 pigment { rgb <0.2, 0.4, 0.8> } }
