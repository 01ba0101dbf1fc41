// Four components where three belong
// error: 4:10 vector
#version 3.7;
sphere { <1, 2, 3, 4>, 1 }
