// Two numbers after the old reflection
// error: 4:39
#version 3.7;
sphere { 0, 1 finish { reflection 0.5 0.2 } }
