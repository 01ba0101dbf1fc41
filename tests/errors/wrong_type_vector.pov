// A vector where a float belongs
// error: 4:13 vector
#version 3.7;
sphere { 0, <1, 2, 3> }
