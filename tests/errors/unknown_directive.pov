// A directive that does not exist
// error: 5:1 '#delcare'
// hint: did you mean '#declare'
#version 3.7;
#delcare A = 1;
