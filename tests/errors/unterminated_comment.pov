// A block comment that is never closed
// error: 4:1 comment
#version 3.7;
/* a comment /* nested */
sphere { 0, 1 }
