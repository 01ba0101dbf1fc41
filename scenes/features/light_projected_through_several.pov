// Lights projected through boxes, unions and spheres; an area light
// class: exact
#version 3.7;
global_settings{assumed_gamma 1.0}
camera{location <0,4,-9> look_at 0 angle 50}
light_source{<0,5,0> rgb <1,0.8,0.5> projected_through{box{<-1,2,-1>,<1,2.2,1> rotate y*20}}}
light_source{<3,6,-2> rgb <0.5,0.8,0> area_light x,z,3,3 projected_through{sphere{<2,3,0> 0.8}}}
light_source{<-3,6,0> rgb <0.5,0.8,1> spotlight point_at 0 radius 20 falloff 30 projected_through{union{sphere{<-1,3,0> 0.3} sphere{<-1.6,3,0.5> 0.3}}}}

plane{y,-1 pigment{rgb 0.8}}
sphere{<0,0,0> 1 pigment{rgb 1}}
sphere{<0.4,1.6,0> 0.3 pigment{rgb 1}}
