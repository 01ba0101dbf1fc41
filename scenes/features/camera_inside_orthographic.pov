// Parallel rays, some of which start inside a glass ball
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-0.5, 0.6, 0.6> look_at <0, 0.6, 5> right 0.6*x up 0.45*y }
light_source { <-1.5, 2.5, -3>, rgb 1 }
light_source { <3, 2, -1>, rgb 0.3 shadowless }
box { <-4, 0, -5>, <4, 3, 4> pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.3, 0.45, 0.6> scale 0.1 } hollow }
sphere { <-0.5, 0.6, 0.6>, 0.2 pigment { rgbf <0.8, 1, 0.9, 0.9> } interior { ior 1.3 fade_distance 0.3 fade_power 1 fade_color rgb <1, 0, 0> } }
