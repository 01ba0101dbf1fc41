// Julia fractals by quaternions and hypercomplex numbers
// class: close — a fractal surface, met in steps
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 15 scale 0.7 translate <-0.8, 0.9, 0> pigment { rgb <0.8, 0.3, 0.2> } }
julia_fractal { <-0.16, 0.2, -0.4, -0.25> hypercomplex sqr max_iteration 6 precision 20 scale 0.7 translate <0.9, 0.7, -0.3> pigment { rgb <0.2, 0.5, 0.8> } }
