// A mesh of smooth triangles: a dome built in a loop
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
#macro Corner(T, P) <cos(T)*sin(P), cos(P), sin(T)*sin(P)> #end
#declare Dome = mesh {
  #for (I, 0, 7)
    #for (J, 0, 2)
      #local A = Corner(I*pi/4, J*pi/6); #local B = Corner((I+1)*pi/4, J*pi/6);
      #local C = Corner(I*pi/4, (J+1)*pi/6); #local D = Corner((I+1)*pi/4, (J+1)*pi/6);
      #if (J > 0) smooth_triangle { A, A, B, B, C, C } #end
      smooth_triangle { C, C, B, B, D, D }
    #end
  #end
}
object { Dome scale <0.9, 1.3, 0.9> translate -0.6*x pigment { rgb <0.8, 0.3, 0.2> } finish { phong 0.7 } }
object { Dome scale 0.6 rotate <0, 0, -70> translate <0.8, 0.6, -0.5> pigment { rgb <0.2, 0.5, 0.8> } finish { phong 0.7 } }
