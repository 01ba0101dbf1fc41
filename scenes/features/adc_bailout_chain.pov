// Weak rays: adc_bailout and max_trace_level in a chain of glass and mirrors
// class: exact
#version 3.7;
global_settings{assumed_gamma 1.0 max_trace_level 4 adc_bailout 0.05}
camera{location <0,1,-7> look_at 0 angle 50}
light_source{<10,20,-20> rgb 1}
background{rgb <0.2,0.3,0.5>}
plane{y,-1.2 pigment{rgb <0.8,0.6,0.4>} finish{reflection 0.4}}
#for(I,0,3) sphere{<-2+I*0.5,0,I*2-2> 1 pigment{rgbf <0.9,1,0.9,0.8>} interior{ior 1.5} finish{reflection{0.3,0.8} }} 
box{<1.5,-1,I>,<3,1,I+0.1> pigment{rgbt <0.5,0.7,1,0.7>} finish{reflection 0.2}} #end
