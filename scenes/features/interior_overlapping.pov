// Glass in glass, overlapping glass, glass with coloured fading
// class: exact
#version 3.7;
global_settings{assumed_gamma 1.0 max_trace_level 12}
camera{location <0,1,-7> look_at 0 angle 50}
light_source{<10,20,-20> rgb 1}
background{rgb <0.2,0.3,0.5>}
union{#for(I,-8,8) #for(J,-8,8) box{<I,-1.1,J>,<I+1,-1,J+1> pigment{rgb mod(I+J+20,2)}} #end #end}
// nested glass, overlapping glass, glass inside water
difference{sphere{<-2,0,0> 1} sphere{<-2,0,0> 0.8} pigment{rgbf <0.9,1,0.9,0.9>} interior{ior 1.5}}
sphere{<0,0,0> 1 pigment{rgbf <1,0.9,0.9,0.9>} interior{ior 1.33 fade_distance 1 fade_power 2 fade_color <0.9,0.5,0.2>}}
sphere{<0.3,0,0> 0.5 pigment{rgbt <0.9,0.9,1,0.8>} interior{ior 1.6 fade_distance 0.5 fade_power 1001 fade_color <0.2,0.5,0.9>} finish{reflection{0,1 fresnel} conserve_energy}}
sphere{<1.9,0,0> 0.7 pigment{rgbf 0.9} interior{ior 1.5} finish{reflection 0.1 specular 0.5}}
sphere{<2.5,0.2,0> 0.7 pigment{rgbf <0.8,1,1,0.7>} interior{ior 1.2} finish{phong 0.5}}
box{<-3,1.2,-1>,<3,1.5,1> rotate x*20 pigment{rgbft <1,1,0.9,0.5,0.4>} interior{ior 2.2}}
