// Julia fractals of hypercomplex functions
// class: close — a fractal surface, met in steps
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.6, -5> look_at 0 angle 45 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
julia_fractal { <-0.5, 0.2, 0, 0> hypercomplex exp max_iteration 8 precision 20 scale 0.5 translate <-1.2, 0, 0> pigment { rgb <0.8, 0.3, 0.2> } }
julia_fractal { <-0.2, 0.3, 0, 0.1> hypercomplex pwr(3, 0) max_iteration 8 precision 20 scale 0.7 translate <1, 0, 0> pigment { rgb <0.2, 0.5, 0.8> } }
