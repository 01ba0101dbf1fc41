// srgb before assumed_gamma
// error: 4:19 assumed_gamma
#version 3.7;
#declare C = srgb <1, 0.5, 0>;
