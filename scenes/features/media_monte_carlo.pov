// Media sampled by method 1, more often where samples vary
// class: close — sampling is random
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 angle 45 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.1, 0.15, 0.2> }
sphere { 0, 1 hollow pigment { rgbt 1 } interior { media { method 1 intervals 5 samples 3, 10 confidence 0.95 variance 0.01 emission <0.7, 0.4, 0.2> scattering { 1, 0.4 } density { spherical } } } }
