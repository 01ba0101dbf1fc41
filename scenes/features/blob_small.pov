// Small blobs throw no shadows on themselves; a long thin one keeps its shape
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> right 0.008*x up 0.006*y look_at 0 }
light_source { <-10, 10, -10>, 1 }
blob {
  cylinder { <-0.001, -0.001, 0>, <0.001, 0.001, 0.001>, 0.001, 2 }
  sphere { <-0.001, 0.001, 0>, 0.0011, 2 }
  pigment { rgb <1, 0.5, 0> }
}
blob {
  cylinder { <0.002, 0, 0>, <0.002, -5000, 0>, 0.0008, 2 }
  sphere { <0.002, 0, 0>, 0.0016, 1 }
  pigment { rgb <0.2, 0.6, 1> }
}
