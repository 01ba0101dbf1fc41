// Photons shared by two targets: one splits them by mirror and lens, with total reflection inside; strays fly far away
// class: close — photons are sampled
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 photons { count 20000 autostop 0 } }
camera { location <0, 6, -9> look_at <0, -.5, 0> angle 50 }
light_source { <-6, 9, -2> 1.4 photons { refraction on } }
prism {
  linear_spline -1, 1, 4, <-1, -1>, <1.2, -1>, <-1, 1.2>, <-1, -1>
  rotate y*25 translate <-1.8, .4, 0>
  pigment { rgb <.8, 1, .8> filter .9 } finish { diffuse 0 ambient 0 reflection .25 } interior { ior 1.5 }
  photons { target refraction on reflection on }
}
sphere {
  <1.8, .4, 0>, 1
  pigment { rgb <1, .9, .7> filter 1 } finish { diffuse 0 ambient 0 } interior { ior 1.3 }
  photons { target refraction on }
}
plane { y, -1 pigment { rgb .8 } finish { ambient 0 diffuse .7 } }
sphere { 0, 400 hollow pigment { rgb <.2, .25, .3> } finish { ambient .3 diffuse .3 } no_shadow }
