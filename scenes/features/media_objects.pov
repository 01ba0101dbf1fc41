// Media of emission, absorption and scattering with densities in hollow objects
// class: exact
#version 3.7;
global_settings{assumed_gamma 1.0}
camera{location <0,1.5,-6> look_at 0 angle 50}
light_source{<5,10,-10> rgb 1}
background{rgb <0.2,0.3,0.5>}
plane{y,-1 pigment{checker rgb 0.9 rgb 0.2}}
sphere{<-1.5,0,0> 1 pigment{rgbt 1} hollow interior{media{emission <1,0.5,0.2> density{spherical color_map{[0 rgb 0][0.3 rgb <0.2,0.5,0>][1 rgb 2]} translate -x*1.5}}}}
sphere{<0.5,0,0> 0.8 pigment{rgbt 1} hollow interior{media{absorption <1,0.5,0.2> density{bozo scale 0.3}}}}
box{<1.4,-1,-0.5>,<2.4,0.5,0.5> rotate y*20 pigment{rgbt 1} hollow interior{media{scattering{1,<0.5,0.8,1>}} media{absorption 0.2 emission 0.1}}}
