// uv_mapping on sphere, box, torus, lathe, sor, ovus and bicubic patch
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,1,-8> look_at <0,0,0> angle 50 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
#declare P=pigment{image_map{png "images/flag.png"}};
sphere{0,1 uv_mapping pigment{P} translate <-3,1.5,0>}
sphere{0,1 uv_mapping pigment{P} rotate <0,90,30> translate <-1,1.5,0>}
box{-.7,.7 uv_mapping pigment{P} rotate <20,30,30> translate <1,1.5,0>}
torus{.7,.3 uv_mapping pigment{P} rotate <20,30,30> translate <3,1.5,0>}
lathe{cubic_spline 5 <.3,-1>,<.3,-.7>,<.8,0>,<.4,.7>,<.4,1> uv_mapping pigment{P} rotate <20,30,30> translate <-3,-1,0>}
sor{5 <.3,-1>,<.3,-.7>,<.8,0>,<.4,.7>,<.4,1> uv_mapping pigment{P} rotate <20,30,30> translate <-1,-1,0>}
ovus{.7,.4 uv_mapping pigment{P} rotate <20,30,30> translate <1,-1,0>}
bicubic_patch{type 1 flatness 0 u_steps 3 v_steps 3 uv_vectors <0,0><1,0><1,1><0,.5>
 <0,0,2.5>,<1,0,2>,<2,0,2>,<3,0.9,2>, <0,1,1>,<1,2,1>,<2,0,1>,<3,1,1>, <0,0.2,0.5>,<1,0,0>,<2,1,0>,<3,0,0.3>, <0,.8,-1>,<1,0,-1>,<2,1,-1.4>,<3,0.1,-1>
 uv_mapping pigment{P} scale .6 translate <2,-1.5,0>}
