// Even sampling, intervals shared between lit and unlit parts
// class: exact
#version 3.7;
global_settings{assumed_gamma 1.0}
camera{location <0,1.5,-6> look_at 0 angle 50}
light_source{<5,10,-10> rgb 0.5}
light_source{<-3,4,0> rgb 1 spotlight point_at <0,0,0> radius 8 falloff 14 }
light_source{<2,5,0> rgb <0.5,1,0.4> cylinder point_at <1.8,0,0> radius 0.3 falloff 0.5 media_interaction on}
plane{y,-1 pigment{checker rgb 0.9 rgb 0.2}}
sphere{<0,0,0> 0.5 pigment{rgb <1,0.5,0.3>}}
box{<-3,-0.99,-1>,<3,3,1.5> pigment{rgbt 1} hollow interior{media{scattering{4,0.15 extinction 0.7} method 2 intervals 6 samples 2 ratio 0.7}}}
