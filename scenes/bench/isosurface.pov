// A gyroid inside a ball
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -5> look_at 0 angle 40 }
light_source { <5, 8, -6>, rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
isosurface {
  function { abs(sin(5*x)*cos(5*y) + sin(5*y)*cos(5*z) + sin(5*z)*cos(5*x)) - 0.3 }
  contained_by { sphere { 0, 1.5 } } max_gradient 9 accuracy 0.001
  pigment { rgb <0.4, 0.7, 0.5> } finish { phong 0.6 }
}
