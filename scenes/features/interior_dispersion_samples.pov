// A prism, dispersion of several strengths and sample counts
// class: exact
#version 3.7;
global_settings{assumed_gamma 1.0 max_trace_level 10}
camera{location <0,1,-7> look_at 0 angle 50}
light_source{<10,20,-20> rgb 1}
background{rgb <0.2,0.3,0.5>}
union{#for(I,-8,8) #for(J,-8,8) box{<I,-1.1,J>,<I+1,-1,J+1> pigment{rgb mod(I+J+20,2)}} #end #end}
sphere{<-1.5,0,0> 1 pigment{rgbf 1} interior{ior 1.5 dispersion 1.1}}
sphere{<1.5,0,0> 1 pigment{rgbf 1} interior{ior 1.3 dispersion 1.05 dispersion_samples 12}}
box{<-0.3,-1,-0.3>,<0.3,2,0.3> rotate y*30 pigment{rgbf <0.9,1,1,0.9>} interior{ior 1.5 dispersion 0.9 dispersion_samples 3} finish{reflection 0.2}}
