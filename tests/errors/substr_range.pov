// substr beyond the end
// error: 4:14 substr
#version 3.7;
#declare S = substr("abc", 3, 4);
