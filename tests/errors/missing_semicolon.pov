// A float declaration without a semicolon
// error: 5:1 ;
#version 3.7;
#declare A = 1
#declare B = 2;
