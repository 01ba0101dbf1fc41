// A parenthesis that is never closed
// error: 4:20 )
#version 3.7;
#declare A = (1 + 2;
