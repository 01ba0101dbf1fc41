// Three planes with different normals and distances
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.9, 0> angle 50 }
light_source { <1, 5, -7>, rgb 1 }
plane { y, -0.2 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> } }
plane { <1, 0.2, -0.4>, -2 pigment { checker rgb <0.8, 0.3, 0.2> rgb <0.6, 0.5, 0.4> scale 0.5 } }
plane { z, 3 rotate <10, 15, 0> pigment { rgb <0.3, 0.4, 0.7> } }
sphere { <0.6, 0.5, 0>, 0.6 pigment { rgb <0.9, 0.8, 0.2> } }
