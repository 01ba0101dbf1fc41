// Photons are light: brilliance, bumps, highlights and crand of the surface that they fall on
// class: close — photons are random
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 photons { spacing 0.02 } }

camera { location <0, 4, -7> look_at <0, 0, 0> angle 35 }
light_source { <-9, 7, 3>, rgb 1 photons { refraction on } }
#macro Field(X, N, B, P)
  box { <X - 0.5, -0.1, -1.4>, <X + 0.5, 0, 1.4> pigment { rgb <0.8, 0.7, 0.6> } normal { bumps N scale 0.3 } finish { diffuse 0.6 brilliance B phong P phong_size 8 } }
#end
Field(-1.5, 0, 3, 0)
Field(-0.5, 0.8, 1, 0)
Field(0.5, 0, 1, 0.8)
Field(1.5, 0, 0.4, 0)
box {
  <-2.6, 0.8, -1.2>, <1.6, 1, 1.2> pigment { rgbf <0.9, 0.95, 1, 0.95> } finish { ambient 0 diffuse 0 } normal { ripples 0.2 scale 0.5 }
  interior { ior 1.3 }
  photons { target refraction on collect off }
}
