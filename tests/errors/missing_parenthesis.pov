// A parenthesis that is never closed
// error: 4:14 '('
#version 3.7;
#declare A = (1 + 2;
