// A hexadecimal number
// error: 4:14 '0x10'
#version 3.7;
#declare A = 0x10;
