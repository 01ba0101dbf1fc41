// Exact solids from CAD: CSG, prisms with bezier outlines, yaw and pitch in a chain, names with underscores
#version 3.6;
#include "colors.inc"
#include "metals.inc"
#include "rad_def.inc"
#declare CamUp = < 0,0,1>;
#declare CamRotation_ = <0, 0, 0>;
global_settings { assumed_gamma 1 ambient_light rgb < 0.3 , 0.3 , 0.3 > }
camera { perspective location < 0, -20 ,0 > look_at < 0 , 0 , 0 > rotate <0,0,0> up < 0, 0, 1> right < 1.777, 0, 0> sky < 0, 0, 1> angle 50 rotate x*0 translate 0 }
#declare Pad_hash_1a2b = difference {
  union {
    box { <0,0,0>, <10.0,10.0,2> translate <0.0, 0.0, 0.0> }
    cone { <0,0,0>, 2, <0, 0, 5>, 0.0 rotate 0.0 translate <5,5,2> }
    prism { bezier_spline linear_sweep 0, 1, 8,
      <0,0>, <1,0>, <2,1>, <2,2>
      <2,2>, <1,3>, <0,2>, <0,0> rotate -90*x }
    torus { 4, 0.5 rotate <90, 0, 0> translate <5,5,0> }
  }
  cylinder { <5,5,-0.1>, <5,5,2.1>, 1 }
  sphere { <0,0,0>, 1 matrix <0.7071,0.7071,0, -0.7071,0.7071,0, 0,0,1, 0,0,0> scale <1,1,2> }
}
#declare StdFinish_ = finish { phong 0.3 };
object { Pad_hash_1a2b
  rotate <0.0, 0.0, 45.0> translate <1, 2, 3>
  pigment { color rgb <0.8, 0.8, 0.8> filter 0.000000 transmit 0 } finish { StdFinish_ }
}
#ifndef (StdFinish) #declare StdFinish = finish { crand 0.01 diffuse 0.8 }; #end
light_source { <0,0,0> color rgb <1,1,1> * 1.5 translate <10,-10,20> area_light x*2, z*2, 2, 2 adaptive 0 circular orient fade_distance 20 fade_power 1 }
#debug concat(vstr(3, min_extent(Pad_hash_1a2b) , ",", 0, 1), "\n") // expect: 0.0,0.0,-1.0
