// Version 3.7 without assumed_gamma
// class: exact
#version 3.7;
camera { location <0.4, 1.2, -5> look_at <0, 0.1, 0> angle 45 }
light_source { <-5, 8, -7>, rgb <1, 0.95, 0.9> }
background { rgb <0.2, 0.3, 0.5> }
#declare I = 0;
#while (I < 8)
  box { <I*0.45 - 1.8, 1, 0>, <I*0.45 - 1.4, 1.4, 0.1> pigment { color rgb I/7 } finish { ambient 1 diffuse 0 } }
  #declare I = I + 1;
#end
sphere { <-1, 0, 0>, 0.8 pigment { color rgb <0.8, 0.4, 0.3> } finish { phong 0.7 } }
sphere {
  <1, 0, 0>, 0.8
  texture { pigment { bozo color_map { [0.3 color rgb <0.9, 0.8, 0.3>] [0.8 color rgb <0.1, 0.2, 0.5>] } scale 0.3 } }
  texture { pigment { gradient y color_map { [0.5 color rgbf <0.9, 0.5, 0.5, 0.6>] [0.5 color rgbf <1, 1, 1, 1>] } scale 0.4 } }
}
plane { y, -0.8 pigment { color rgb <0.5, 0.6, 0.5> } }
