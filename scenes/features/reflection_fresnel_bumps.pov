// Fresnel mirrors with and without an interior, where bumps turn parts of the surface away from the ray.
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 3 }
camera { location <0, 1.5, -6> look_at <0, 0.3, 0> right x*4/3 angle 40 }
light_source { <-10, 20, -15>, rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, -0.8 pigment { checker rgb <0.8, 0.7, 0.5> rgb <0.2, 0.3, 0.2> } }
sphere {
  <-1, 0.2, 0>, 0.9
  pigment { rgb <0.1, 0, 0.2> }
  normal { ripples 3 frequency 4 scale 0.5 }
  finish { reflection { 0.1, 1 fresnel } }
}
sphere {
  <1, 0.2, 0>, 0.9
  pigment { rgb <0.1, 0, 0.2> }
  normal { ripples 3 frequency 4 scale 0.5 }
  finish { reflection { 0.1, 1 fresnel } }
  interior { ior 1.3 }
}
