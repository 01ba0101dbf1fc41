// A material map with fewer textures than its picture has colours.
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> right x*4 up y*3 }
light_source { <-10, 20, -30>, rgb 1 }
box {
  <-1.9, -1.4, 0>, <0, 1.4, 1>
  texture { material_map { png "images/tiles.png"
    texture { pigment { rgb x } } texture { pigment { rgb y } } texture { pigment { rgb z } } } scale 0.9 }
}
box {
  <0.1, -1.4, 0>, <1.9, 1.4, 1>
  texture { material_map { png "images/tiles.png" texture { pigment { rgb x } } texture { pigment { rgb y } } } scale 0.9 }
}
