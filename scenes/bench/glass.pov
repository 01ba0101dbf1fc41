// Glass balls and mirrors in the soft light of an area
// class: close — the points of the light are shifted at random
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 3, -7> look_at <0, 0.6, 0> angle 42 }
light_source { <5, 8, -6>, rgb 1 area_light 3*x, 3*z, 6, 6 adaptive 1 jitter }
light_source { <-6, 5, -4>, rgb 0.4 }
background { rgb <0.4, 0.5, 0.7> }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.4, 0.5> } finish { reflection 0.1 } }
#for (I, 0, 8)
  sphere { <mod(I, 3)*1.5 - 1.5, 0.6, div(I, 3)*1.5 - 1.5>, 0.6
    #if (mod(I, 2) = 0) pigment { rgbf <0.95, 1, 0.97, 0.95> } finish { reflection { 0.05, 0.9 fresnel } conserve_energy specular 0.7 } interior { ior 1.5 }
    #else pigment { rgb <0.9, 0.3, 0.2> } finish { phong 0.8 reflection 0.2 } #end }
#end
