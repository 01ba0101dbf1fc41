// A tail without a newline is lost
#version 3.7;
#debug "whole\n"
#debug "tail"

// expect: whole
