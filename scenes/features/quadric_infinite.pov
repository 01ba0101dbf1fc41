// An unclipped saddle reaches the horizon
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.5, 3, -5> look_at <0, 0, 0> angle 60 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
quadric { <0.3, 0, -0.4>, <0, 0, 0>, <0, -1, 0.2>, -0.4 pigment { checker rgb <0.8, 0.3, 0.2> rgb <0.9, 0.8, 0.6> scale 0.6 } }
