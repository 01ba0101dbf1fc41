// A quartic with too few numbers
// error: 4:11
#version 3.7;
quartic { <1, 2, 3> }
