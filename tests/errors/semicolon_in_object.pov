// A semicolon inside an object
// error: 4:14 ;
#version 3.7;
sphere { 0, 1; }
