// Bump maps asked to use the palette's numbers of a picture that has no palette: its brightness counts.
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> right x*4 up y*3 }
light_source { <-10, 20, -30>, rgb 1 }
sphere {
  <-1, 0, 0>, 0.9
  pigment { rgb 0.9 }
  normal { bump_map { png "images/flag.png" use_index bump_size 2 } scale 1.3 }
}
sphere {
  <1, 0, 0>, 0.9
  pigment { rgb 0.9 }
  normal { bump_map { png "images/hills.png" use_index bump_size 4 } scale 1.3 }
}
