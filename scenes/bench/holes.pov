// A plate with 400 drilled holes
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <-4, 9, -14> look_at <0, -0.6, 0> angle 52 }
light_source { <8, 14, -10>, rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
difference {
  box { <-7, -0.6, -7>, <7, 0, 7> }
  #for (I, 0, 19) #for (J, 0, 19) cylinder { <I*0.7 - 6.65, -1, J*0.7 - 6.65>, <I*0.7 - 6.65, 1, J*0.7 - 6.65>, 0.25 } #end #end
  pigment { rgb <0.8, 0.7, 0.4> } finish { phong 0.5 }
}
