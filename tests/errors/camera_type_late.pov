// The type of a camera after its items
// error: 4:24
#version 3.7;
camera { location -3*z orthographic }
