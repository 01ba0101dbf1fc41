// Photons of a fading spotlight through coloured glass stand for its light; the floor on the right does not collect them
// class: close — photons are sampled
#version 3.7;
global_settings { assumed_gamma 1 photons { count 40000 } }
camera { location <0, 6, -5> look_at <0, 0, 0> angle 40 }
light_source { <0, 5, 0>, rgb 2 spotlight point_at 0 radius 20 falloff 30 fade_distance 4 fade_power 2 }
box { <-4, -1, -4>, <0, 0, 4> pigment { rgb 0.7 } }
box { <0, -1, -4>, <4, 0, 4> pigment { rgb 0.7 } photons { collect off } }
box { <-1, 2, -1>, <1, 2.1, 1> pigment { rgbf <1, 0.7, 0.6, 1> } finish { diffuse 0 } interior { ior 1.3 } photons { target refraction on } }
