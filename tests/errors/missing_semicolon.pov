// A float declaration without a semicolon
// error: 4:14 ;
#version 3.7;
#declare A = 1
#declare B = 2;
