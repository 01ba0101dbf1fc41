// Thin films with turbulence, seen directly, in a mirror and through glass
// class: exact
#version 3.7;
global_settings{assumed_gamma 1.0}
camera{location <0,2,-5> look_at 0 angle 50}
light_source{<5,10,-10> rgb 1}
light_source{<-5,10,-10> rgb <0.5,0.6,0.3> shadowless}
sphere{<-1.2,0,0> 1 pigment{rgb 0.5} finish{irid{0.35 thickness 0.5 turbulence 0.5} phong 0.5 ambient 0.2}}
sphere{<1.2,0,0> 1 pigment{rgb 0.5} finish{irid{0.9 thickness 5} reflection 0.3}}
box{<-3,-1.5,-1>,<3,-1,1> pigment{rgbt 0.5} finish{irid{0.4 thickness 0.8 turbulence 1} brilliance 2 diffuse 0.9 ambient 0}}
