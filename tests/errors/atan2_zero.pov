// atan2(0, 0)
// error: 4:14 atan2
#version 3.7;
#declare A = atan2(0, 0);
