// An item that a camera does not have
// error: 4:22 'radius'
#version 3.7;
camera { location -z radius 3 }
