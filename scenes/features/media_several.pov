// Several media in one place scatter by the mean of their phase functions, in one interior and in nested ones
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -9> look_at 0 angle 42 }
light_source { <6, 5, 8>, rgb 1 }
light_source { <-6, 5, -8>, rgb <0.5, 0.4, 0.2> }
background { rgb 0.2 }
#default { pigment { rgbf 1 } finish { ambient 0 diffuse 0 } }

box {
  <-3, -1, -1>, <-1, 1, 1> hollow
  interior {
    media { scattering { 2, rgb <0.1, 0.05, 0.1> } }
    media { scattering { 5, rgb <0.05, 0.1, 0.2> eccentricity -0.4 } density { spherical translate <-2, 0, 0> } }
    media { emission <0, 0.05, 0> }
  }
}
box { <-0.9, -1, -1>, <0.9, 1, 1> hollow interior { media { scattering { 3, rgb 0.1 } } } }
box { <0, -0.7, -0.7>, <2, 0.7, 0.7> hollow interior { media { scattering { 4, rgb <0.05, 0.1, 0.2> } method 1 intervals 3 samples 1, 1 } } }
sphere { <2.3, 0, 0>, 0.6 hollow interior { media { scattering { 1, 0.2 } } media { scattering { 2, 0 } absorption <0.3, 0.1, 0> } } }
