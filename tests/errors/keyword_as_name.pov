// A reserved word as a name
// error: 4:10 'sphere'
#version 3.7;
#declare sphere = 1;
