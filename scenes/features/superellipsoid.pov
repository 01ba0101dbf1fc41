// Superellipsoids: rounded box, star and pillow
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
superellipsoid { <0.2, 0.2> scale 0.5 rotate 20*y translate <-1, 0.55, 0> pigment { rgb <0.8, 0.3, 0.2> } finish { phong 0.6 } }
superellipsoid { <2.5, 0.8> scale 0.6 rotate <30, 20, 0> translate <0.4, 0.7, 0.3> pigment { rgb <0.9, 0.8, 0.2> } }
superellipsoid { <1, 0.3> scale 0.4 rotate <70, 0, 20> translate <0.9, 0.5, -0.8> pigment { rgb <0.2, 0.5, 0.8> } }
