// Subsurface light transport
// class: close — sampled
#version 3.7;
global_settings { assumed_gamma 1 mm_per_unit 10 subsurface { samples 20, 20 } }
camera { location <0.5, 1.5, -5> look_at <0.1, 0.2, 0> angle 40 }
light_source { <5, 4, 2>, rgb 1 }
background { rgb <0.2, 0.25, 0.3> }
sphere { <0, 0.2, 0>, 1 pigment { rgb <0.9, 0.7, 0.6> } finish { subsurface { translucency rgb <0.9, 0.5, 0.3> } } interior { ior 1.3 } }
