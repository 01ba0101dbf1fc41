// A declaration of nothing
// error: 4:1
#version 3.7;
#declare A = ;
