// A declaration of nothing
// error: 4:14
#version 3.7;
#declare A = ;
