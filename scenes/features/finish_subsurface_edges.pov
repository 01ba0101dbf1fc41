// Subsurface light transport: how far light creeps into a shadow, by translucency, colour and ior; a black channel
// class: close — sampled
#version 3.7;
global_settings { assumed_gamma 1 mm_per_unit 10 subsurface { samples 100, 30 } }
camera { orthographic location 10*y sky z look_at 0 right 8*x up 6*z }
light_source { <0, 100, 0>, rgb 0.8 parallel point_at 0 }
#declare Shade = box { <-9, 3, 0>, <9, 4, 0.7> no_image }
object { Shade translate -2*z } object { Shade } object { Shade translate 2*z }
#macro Slab(X, C, T, N)
  box { <X - 0.95, -2, -3>, <X + 0.95, 0, 3> pigment { rgb C } finish { ambient 0 diffuse 1 subsurface { translucency T } } interior { ior N } }
#end
Slab(-3, <0.95, 0.8, 0.5>, 1, 1.3)
Slab(-1, <0.4, 0.2, 0.05>, <1, 2, 4>, 1.3)
Slab(1, 0.8, <0.5, 2, 4>, 1.6)
Slab(3, <0.9, 0, 0.5>, 2, 1)
