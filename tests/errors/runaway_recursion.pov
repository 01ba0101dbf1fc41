// A macro that calls itself for ever
// error: 4:21 recursion
#version 3.7;
#macro Down(N) Down(N + 1) #end
Down(1)
