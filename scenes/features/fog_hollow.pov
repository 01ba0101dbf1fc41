// Fog is not seen from inside solid objects, only from inside hollow ones
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,1,-4> look_at <0,1,0> }
light_source{<-5,8,-6> rgb 1}
fog { distance 8 rgb <.7,.7,.9> }
plane { y, 0 pigment { checker rgb .8 rgb .2 } }
sphere{0 60 pigment{rgbt 1}}
sphere{<1,1,0> 1 pigment{rgbt 1}}
sphere{<-1,1,0> 1 pigment{rgbt 1} hollow}
