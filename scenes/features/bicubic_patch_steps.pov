// Bicubic patches: types, flatness, unequal steps
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.5, 5.3, -8> look_at <2.5, 0.7, 0> angle 60 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
#macro B(T,F,U,V,P,C) bicubic_patch { type T flatness F u_steps U v_steps V #if(C) uv_vectors <0,0><1,0><1,1><0,1> #end
 <0,0,2.5>,<1,0,2>,<2,0,2>,<3,0.9,2>, <0,1,1>,<1,2,1>,<2,0,1>,<3,1,1>, <0,0.2,0.5>,<1,0,0>,<2,1,0>,<3,0,0.3>, <0,.8,-1>,<1,0,-1>,<2,1,-1.4>,<3,0.1,-1>
 #if(C) uv_mapping pigment{image_map{png "images/flag.png"}} #else pigment{rgb <.8,.4,.3>} interior_texture{pigment{rgb y}} #end finish{specular .3} translate P} #end
B(0,0.4,4,3,<-2,0,0>,0)
B(1,0.1,3,3,<-2,1.5,3>,0)
B(0,0.03,4,5,<2.2,1.5,3>,0)
B(1,0,3,1,<1.5,-.4,0>,0)
B(1,0.2,3,3,<5,0,0>,1)
B(0,0.00,2,4,<5,1.5,4>,0)
