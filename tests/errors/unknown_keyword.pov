// A misspelt keyword inside an object
// error: 5:15 'pigmnet'
// hint: did you mean 'pigment'
#version 3.7;
sphere { 0, 1 pigmnet { rgb 1 } }
