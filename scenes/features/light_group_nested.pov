// Light groups in light groups: the outermost decides about global lights
// class: exact
#version 3.7;
global_settings{assumed_gamma 1.0}
camera{orthographic location <0,0,-9> look_at 0 right 16*x up 2*y}
light_source{<0,0,-1000> rgb <0.1,0,0>}
#for(I,0,7)
#local A=mod(I,2); #local B=mod(int(I/2),2); #local C=int(I/4);
light_group{
 light_source{<0,0,-1000> rgb <0,0.2,0>}
 light_group{ light_source{<0,0,-1000> rgb <0,0,0.4>} 
   box{<-0.4,-0.8,0>,<0.4,0,1> pigment{rgb 1} finish{ambient 0 diffuse 1}} #if(C=0) global_lights A #end }
 box{<-0.4,0.1,0>,<0.4,0.8,1> pigment{rgb 1} finish{ambient 0 diffuse 1}}
 #if(C=0) global_lights B #end
 translate <I*2-7,0,0>
}
#end
