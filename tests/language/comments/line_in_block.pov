// A line comment does not hide the end of a block
#version 3.7;
/* // */
#debug "after\n" // expect: after
