// A keyword with a capital letter is a name
// error: 5:1 'Sphere'
// hint: did you mean 'sphere'
#version 3.7;
Sphere { 0, 1 }
