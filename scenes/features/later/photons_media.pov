// Photons in media: beams behind a lens and off a mirror, in a box of haze that is itself not in their way
// class: close — photons are random
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 photons { spacing 0.06 media 50, 1 } }

camera { location <0, 3, -7> look_at <0, 0.6, 0> angle 40 }
light_source { <-20, 1, 0>, rgb 0.7 spotlight radius 2 falloff 2.6 point_at <0, 0.8, 0> photons { reflection on refraction on } }
light_source { <0, 9, -6>, rgb 0.4 media_interaction off photons { reflection off refraction off } }
plane { y, 0 pigment { rgb <0.5, 0.5, 0.6> } finish { ambient 0 } }
box {
  <-2.5, 0.01, -2>, <2.6, 1.6, 2> hollow
  pigment { rgbf 1 } finish { ambient 0 diffuse 0 }
  interior { media { scattering { 1, 0.4 extinction 0.2 } method 3 samples 4, 4 } }
  photons { target }
}
sphere {
  0, 0.6 scale <0.5, 1, 1> translate <-1, 0.8, 0>
  pigment { rgbf <1, 0.9, 0.7, 0.98> } finish { ambient 0 diffuse 0 }
  interior { ior 1.5 }
  photons { target refraction on reflection off collect off }
}
box {
  <-0.05, -0.6, -0.7>, <0.05, 0.6, 0.7> rotate y*-40 translate <1.4, 0.8, 0>
  pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection rgb <0.6, 0.8, 1> }
  photons { target reflection on refraction off collect off }
}
