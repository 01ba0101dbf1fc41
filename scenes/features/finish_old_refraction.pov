// Before 3.1: ior, refraction and caustics in the finish; lower layers seen, and lit, through filter as through transmit
// class: exact
#version 3.0;
global_settings { assumed_gamma 2.2 }
camera { location <0, 2, -6> look_at <0, 0.3, 0> angle 40 }
light_source { <3, 8, -2>, rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, -1 pigment { checker rgb 0.9 rgb <0.3, 0.5, 0.3> } }
sphere { <-2, 0, 0>, 0.9 pigment { rgbf <0.9, 0.8, 0.7, 0.8> } finish { ior 1.3 refraction 0.7 caustics 0.6 phong 1 } }
sphere { <0, 0, 0>, 0.9 pigment { rgbf <0.9, 0.9, 0.9, 0.9> } finish { ior 1.5 refraction 1 caustics 2 reflection 0.2 } }
box { <1.2, -0.8, -0.6>, <2.4, 0.4, 0.6>
  texture { pigment { rgbf <0.9, 0.4, 0.2, 0.6> } }
  texture { pigment { rgbft <0.5, 0.9, 0.3, 0.5, 0.2> } finish { specular 0.5 } }
}
