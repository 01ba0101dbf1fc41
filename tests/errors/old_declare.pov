// declare without # warns
// warning: 4:1 declare
#version 3.7;
declare A = 1;
