// Focal blur without a focal_point: sharp at a distance of 1, whatever the length of direction
// class: close — random lens points
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -2> direction 2*z aperture 0.3 blur_samples 200 variance 0 }
light_source { <-3, 5, -6>, rgb 1 }
plane { y, -0.5 pigment { checker rgb 0.9 rgb <0.3, 0.4, 0.5> scale 0.25 } }
sphere { <-0.2, 0, -1>, 0.2 pigment { rgb <0.9, 0.3, 0.2> } }
sphere { <0.5, 0, 1>, 0.5 pigment { rgb <0.2, 0.5, 0.9> } }
