// A version that changes within the file
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
#local Saved = version;
#version 3.1;
#declare Old = texture { pigment { bozo color_map { [0.3 rgb <0.9, 0.5, 0.2>] [0.8 rgb <0.1, 0.2, 0.5>] } scale 0.3 } finish { phong 0.5 } }
#version Saved;
#declare New = texture { pigment { bozo color_map { [0.3 rgb <0.9, 0.5, 0.2>] [0.8 rgb <0.1, 0.2, 0.5>] } scale 0.3 } finish { phong 0.5 } }
camera { location <0.5, 1.5, -5> look_at <0, 0, 0> angle 45 }
light_source { <-5, 8, -7>, rgb 1 }
sphere { <-1, 0, 0>, 0.9 texture { Old } }
sphere { <1, 0, 0>, 0.9 texture { New } }
