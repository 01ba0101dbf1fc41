// A version that is no number
// error: 3:10
#version "3.7";
