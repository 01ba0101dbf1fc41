// A component that the vector does not have
// error: 5:16 'z'
#version 3.7;
#declare V = <1, 2>;
#declare A = V.z;
