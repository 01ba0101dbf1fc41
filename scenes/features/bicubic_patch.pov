// Bicubic patches of both types
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
#macro Sheet(Type)
bicubic_patch {
  type Type flatness 0.01 u_steps 3 v_steps 3
  <-0.6, 0, 0>, <-0.2, 0.6, 0>, <0.3, -0.3, 0.1>, <0.6, 0.2, 0>,
  <-0.6, 0.3, 0.4>, <-0.2, 1, 0.4>, <0.3, 0.1, 0.4>, <0.6, 0.5, 0.4>,
  <-0.7, 0.5, 0.8>, <-0.2, 0.9, 0.8>, <0.2, 0.9, 0.8>, <0.6, 0.8, 0.7>,
  <-0.6, 1, 1.1>, <-0.2, 1.2, 1>, <0.3, 1.4, 1>, <0.7, 0.9, 1>
  uv_mapping pigment { checker rgb <0.9, 0.8, 0.2> rgb <0.6, 0.2, 0.4> scale 0.2 }
}
#end
object { Sheet(0) translate -0.9*x }
object { Sheet(1) rotate 30*y translate <0.6, 0, -0.6> }
