// A string without its closing quote
// error: 4:8 string
#version 3.7;
#debug "never ends
