// A vector of six components
// error: 4:14
#version 3.7;
#declare V = <1, 2, 3, 4, 5, 6>;
