// A ring of metal throws light on the floor: photons by reflection
// class: close — photons are sampled
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.02 } }
camera { location <0, 5, -4> look_at <0, 0, 0.3> angle 40 }
light_source { <-6, 7, 3>, rgb 1 }
plane { y, 0 pigment { rgb 0.7 } }
difference {
  cylinder { 0, 0.5*y, 1 }
  cylinder { -y, y, 0.95 }
  pigment { rgb <0.8, 0.5, 0.2> }
  finish { ambient 0.1 diffuse 0.2 reflection { rgb <0.9, 0.7, 0.4> } }
  photons { target reflection on refraction off }
}
