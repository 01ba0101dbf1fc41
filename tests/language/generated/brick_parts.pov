// Defaults that users may set before, version tests between keywords, materials chosen by version
#ifndef (L3Version) #declare L3Version = 1.0; #end
#ifndef (L3Quality)
#declare L3Quality = 2;
#end
#ifndef (L3IORBlack) #declare L3IORBlack = 1.51; #end
#declare L3Saved = version;
#version 3.7;
global_settings { assumed_gamma 1.4 max_trace_level 5 adc_bailout 0.01/2 }
#declare L3Texture4 = #if (version >= 3.1) material { #end texture {
  pigment { rgbf <0.76,0.12,0.12,0> #if (L3Quality > 1) #end }
  #if (L3Quality > 1) finish { ambient 0.4 diffuse 0.4 } #end }
  #if (version >= 3.1) interior { ior L3IORBlack } } #end
#declare _3005_dot_dat = union {
  box { <-10,0,-10>, <10,24,10> }
  #if (L3Quality > 1) cylinder { <0,-4,0>, <0,0,0>, 6 } #end
  mesh { triangle { <0,0,0>, <1,0,0>, <0,1,0> } smooth_triangle { <0,0,0>,<0,0,1>, <1,0,0>,<0,0,1>, <0,1,0>,<0,0,1> } }
}
object { _3005_dot_dat
  matrix <0.975,0,0,0,0.975,0,0,0,0.975,0,-0.175,0>
  #if (version >= 3.1) material #else texture #end { L3Texture4 }
}
#macro L3Edge(A, B) #if (A.x != B.x) cylinder { A, B, 0.5 pigment { rgb 0 } } #else sphere { A, 0.5 } #end #end
L3Edge(<0,0,0>, <1,0,0>)
L3Edge(<0,0,0>, <0,1,0>)
#debug concat(vstr(3, max_extent(_3005_dot_dat), ",", 0, 1), "\n") // expect: 10.0,24.0,10.0
