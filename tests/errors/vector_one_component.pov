// A vector of one component
// error: 4:14
#version 3.7;
#declare V = <1>;
