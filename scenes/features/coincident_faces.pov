// Boxes whose tops lie in one plane: which is seen hangs on where the ray enters their boxes, to the last bit
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 1 diffuse 0 } }
camera { location <-8, 4, -14> look_at <0, 0, 0> angle 40 }

union {
  box { -1, 1 translate -y scale <3, 1, 3> translate -3*x pigment { rgb <0.5, 0.1, 0> } }
  box { -1, 1 translate <3, -1, 3> pigment { rgb <0, 0.2, 0.5> } }
  box { -1, 1 scale <8, 0.25, 8> translate -0.25*y }
  pigment { rgb <0.8, 0.7, 0.4> }
}
