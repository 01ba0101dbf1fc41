// A camera that looks at where it stands
// error: 4:1 look_at
#version 3.7;
camera { location <1, 2, 3> look_at <1, 2, 3> }
