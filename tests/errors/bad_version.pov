// A version that does not exist
// error: 3:10
#version 9.9;
