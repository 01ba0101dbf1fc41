// A sky sphere with a gradient and layered clouds
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at <0.3, 1.7, 0> angle 80 }
light_source { <-5, 8, -7>, rgb 1 }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.8, 0.85, 0.9>] [0.6 rgb <0.1, 0.2, 0.6>] } }
  pigment { bozo color_map { [0.45 rgbt 1] [0.7 rgbt <1, 0.95, 0.9, 0.1>] } scale <0.3, 0.1, 0.3> turbulence 0.4 }
}
plane { y, -0.5 pigment { rgb <0.3, 0.5, 0.2> } finish { reflection 0.3 } }
sphere { <0.3, 0.6, 0>, 0.9 pigment { rgb 0.1 } finish { reflection 0.8 } }
