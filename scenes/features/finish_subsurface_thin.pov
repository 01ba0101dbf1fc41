// Subsurface light transport through thin and cut objects, lit from behind, with highlights and a shadow's soft edge
// class: close — sampled
#version 3.7;
global_settings { assumed_gamma 1 mm_per_unit 20 subsurface { samples 100, 20 } }
camera { location <0, 2, -6> look_at <0, 0.4, 0> angle 40 }
light_source { <4, 5, 6>, rgb <0.9, 0.8, 0.7> }
light_source { <-5, 6, -3>, rgb <0.3, 0.4, 0.5> }
background { rgb <0.2, 0.25, 0.3> }
#declare Plain = finish { ambient 0 diffuse 0.6 }
#default { finish { ambient 0 diffuse 0.8 specular 0.4 subsurface { translucency <4, 2, 1> } } }
#declare Wax = interior { ior 1.4 }
difference {
  box { <-2, 0, -0.2>, <-0.4, 1.5, 0.2> }
  sphere { <-1.2, 0.8, -0.2>, 0.5 }
  pigment { rgb <0.9, 0.7, 0.4> }
  interior { Wax }
}
torus { 0.5, 0.15 rotate 90*x translate <0.4, 0.65, 0> pigment { rgb <0.4, 0.8, 0.5> } interior { Wax } }
blob { threshold 0.5 sphere { <1.5, 0.4, 0>, 0.9, 1 } sphere { <1.5, 1, 0>, 0.7, 1 } pigment { rgb <0.9, 0.5, 0.5> } interior { ior 1.3 } }
plane { y, 0 texture { pigment { rgb <0.7, 0.7, 0.8> } finish { Plain } } }
