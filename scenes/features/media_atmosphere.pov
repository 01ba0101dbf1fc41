// Media in the atmosphere, lamps with and without attenuation and interaction
// class: exact
#version 3.7;
global_settings{assumed_gamma 1.0}
camera{location <0,1.5,-6> look_at 0 angle 50}
light_source{<5,10,-10> rgb 0.5 media_interaction off media_attenuation on}
light_source{<-3,4,0> rgb 1 spotlight point_at <0,0,0> radius 8 falloff 14 media_attenuation on}
light_source{<2,5,0> rgb <0.5,1,0.4> spotlight point_at <1.8,0,0> radius 5 falloff 10}
plane{y,-1 pigment{checker rgb 0.9 rgb 0.2}}
plane{z,4 pigment{rgb 0.5}}
sphere{<0,0,0> 0.5 pigment{rgb <1,0.5,0.3>}}
box{<-1.4,-1,-0.5>,<-0.8,-0.2,0.5> pigment{rgbf <1,0.6,0.6,0.8>} interior{ior 1.2}}
media{scattering{5,0.1 eccentricity 0.3 extinction 0.5} absorption <0.02,0.01,0> intervals 4 samples 6 method 2}
