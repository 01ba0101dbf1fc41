// A perspective camera of 180 degrees
// error: 4:40 angle
#version 3.7;
camera { location -3*z look_at 0 angle 180 }
