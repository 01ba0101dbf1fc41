// A hexadecimal number
// error: 4:15
#version 3.7;
#declare A = 0x10;
