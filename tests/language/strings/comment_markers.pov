// Comment markers inside strings are text
#version 3.7;
#debug "a // b /* c */ d\n" // expect: a // b /* c */ d
