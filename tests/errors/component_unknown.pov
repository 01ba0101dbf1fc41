// A component that no vector has
// error: 5:16 'w'
#version 3.7;
#declare V = <1, 2, 3>;
#declare A = V.w;
