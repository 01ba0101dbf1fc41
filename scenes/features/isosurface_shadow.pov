// The shadow of a see-through isosurface: light passes its back as well as its front, whatever max_trace says
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at <0, 0.4, 0> angle 40 }
light_source { <-3, 6, -2>, 1 }
plane { y, -0.6 pigment { rgb 0.8 } finish { ambient 0.05 diffuse 0.8 } }
isosurface {
  function { x*x + 2*y*y + z*z - 0.5 }
  contained_by { box { -1, 1 } }
  max_gradient 5
  pigment { rgbf <0.6, 1, 0.6, 0.7> }
  translate -x
}
isosurface {
  function { x*x + y*y + z*z - 0.4 }
  contained_by { box { -1, 1 } }
  max_gradient 5
  max_trace 2
  pigment { rgbt <1, 0.7, 0.6, 0.5> }
  translate x
}
