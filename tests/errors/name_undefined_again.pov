// A value used before it is set by #undef
// error: 6:14 'A'
#version 3.7;
#declare A = 1;
#undef A
#declare B = A;
