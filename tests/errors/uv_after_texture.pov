// uv_mapping after the texture
// error: 4:33 uv_mapping
#version 3.7;
sphere { 0, 1 pigment { rgb 1 } uv_mapping }
