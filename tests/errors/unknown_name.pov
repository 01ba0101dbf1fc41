// A name that nobody declared
// error: 6:13 'Radius'
// hint: did you mean 'Radus'
#version 3.7;
#declare Radus = 2;
sphere { 0, Radius }
