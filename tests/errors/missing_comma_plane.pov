// Without a comma y -1 is a subtraction
// error: 4:14
#version 3.7;
plane { y -1 }
