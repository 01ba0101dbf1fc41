// looks_like in unions and light groups
// class: exact
#version 3.7;
global_settings{assumed_gamma 1.0}
camera{location <0,4,-9> look_at 0 angle 50}
light_source{<0,3,0> rgb 0.6 looks_like{sphere{0,0.3 pigment{rgb <1,1,0>} finish{ambient 1}}}}
union{light_source{<2,2,0> rgb 0.3 looks_like{box{-0.2,0.2 pigment{rgb <1,0,0>}}}} sphere{<1.5,0,0> 0.4} pigment{rgb <0,1,0>} translate -x*0.5}
light_group{light_source{<-2,2,0> rgb 0.3 looks_like{box{-0.2,0.2 finish{ambient 1}} translate x*0.3}} sphere{<-1.5,0,0> 0.4} rotate y*20}

plane{y,-1 pigment{rgb 0.8}}
