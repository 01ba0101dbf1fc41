// Finishes of many terms on transparent spheres
// class: exact
#version 3.7;
global_settings{assumed_gamma 1.0 max_trace_level 8}
camera{location <0,1,-12> look_at 0 angle 50}
light_source{<10,20,-20> rgb 1} light_source{<-15,5,-10> rgb <0.3,0.3,0.6>}
light_source{<0,-10,10> rgb <0.5,0.2,0.1>}
background{rgb <0.2,0.3,0.5>}
plane{y,-4.5 pigment{rgb <0.6,0.5,0.3>}}
plane{z,12 pigment{rgb <0.3,0.5,0.4>} finish{ambient 0.3}}
#declare R=seed(7);
#for(I,0,6) #for(J,0,4)
sphere{<(I-3)*1.6,(J-2)*1.6,0> 0.75
 pigment{rgb <0.2+0.8*rand(R),rand(R),rand(R)> #if(rand(R)<0.4) filter rand(R)*0.9 #end #if(rand(R)<0.3) transmit 0.3*rand(R) #end}
 finish{ambient rand(R)*0.2 diffuse rand(R), rand(R)*0.5 
  #if(rand(R)<0.5) brilliance 0.5+3*rand(R) #end
  #if(rand(R)<0.5) phong rand(R) phong_size 5+60*rand(R) #end
  #if(rand(R)<0.5) specular rand(R) roughness 0.001+0.1*rand(R) #end
  #if(rand(R)<0.4) metallic rand(R) #end
  #if(rand(R)<0.6) reflection{rgb <rand(R),rand(R),rand(R)>*0.5, rgb <rand(R),rand(R),rand(R)> #if(rand(R)<0.4) fresnel #end #if(rand(R)<0.4) metallic rand(R) #end #if(rand(R)<0.4) falloff 0.5+3*rand(R) #end #if(rand(R)<0.3) exponent 0.5+rand(R) #end} #end
  #if(rand(R)<0.4) conserve_energy #end
  #if(rand(R)<0.4) emission rand(R)*0.2 #end
  #if(rand(R)<0.3) irid{0.2+0.3*rand(R) thickness 0.2+rand(R) } #end
 }
 interior{ior 1+rand(R)*0.6 #if(rand(R)<0.4) fade_distance 0.2+rand(R) fade_power 1+floor(rand(R)*2) fade_color <rand(R),rand(R),rand(R)> #end #if(rand(R)<0.4) caustics rand(R) #end }
}
#end #end
