// A camera inside glass
// class: exact
#version 3.7;
global_settings{assumed_gamma 1.0 max_trace_level 12}
camera{location <0,0.2,-1> look_at <0,0,3> angle 80}
light_source{<10,20,-20> rgb 1}
background{rgb <0.2,0.3,0.5>}
union{#for(I,-8,8) #for(J,-3,14) box{<I,-1.1,J>,<I+1,-1,J+1> pigment{rgb mod(I+J+20,2)}} #end #end}
sphere{<0,0,0> 2 pigment{rgbf <0.9,1,0.9,0.9>} interior{ior 1.5 fade_distance 2 fade_power 1}}
sphere{<-0.5,0,1> 0.3 pigment{rgbf <1,0.9,0.9,0.9>} interior{ior 1.0}}
sphere{<0.5,0,1> 0.3 pigment{rgbf <1,0.9,0.9,0.9>} interior{ior 1.5}}
sphere{<0.5,0.7,1> 0.3 pigment{rgb <1,0.9,0.2>} }
sphere{<-3,0,5> 1 pigment{rgb <1,0.2,0.2>} }
