// A mirror ball with nine smaller ones around it, and so on: 7381 balls, three lights
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
camera { location <2.1, 1.7, -1.3> look_at <0, -0.1, 0> angle 45 }
light_source { <4, 3, -2>, rgb 0.6 }
light_source { <1, 4, -4>, rgb 0.6 }
light_source { <-3, 5, -1>, rgb 0.6 }
background { rgb <0.08, 0.36, 0.57> }
#declare Ball = texture { pigment { rgb <1, 0.9, 0.7> } finish { diffuse 0.5 phong 0.5 phong_size 30 reflection 0.5 ambient 0.05 } }
// The nine directions in which a ball carries smaller ones: six around its equator, three nearer to its pole.
#macro Flake(Place, Pole, Radius, Level)
  sphere { Place, Radius }
  #if (Level > 0)
      #if (abs(Pole.x) > 0.9) #local Side = vnormalize(vcross(Pole, y)); #else #local Side = vnormalize(vcross(Pole, x)); #end
    #local Other = vcross(Pole, Side);
    #for (I, 0, 8)
      #local Turn = radians(I < 6 ? I*60 : I*120 + 30);
      #local Height = (I < 6 ? 0 : 0.8165);
      #local Way = vnormalize((cos(Turn)*Side + sin(Turn)*Other)*sqrt(1 - Height*Height) + Height*Pole);
      Flake(Place + Way*Radius*4/3, Way, Radius/3, Level - 1)
    #end
  #end
#end
union { Flake(<0, 0, 0>, y, 0.5, 4) texture { Ball } }
plane { y, -0.5 pigment { rgb <1, 0.75, 0.33> } finish { diffuse 0.8 ambient 0.05 } }
