// Too many arguments
// error: 5:15 2
#version 3.7;
#macro Pair(A, B) A + B #end
#declare X1 = Pair(1, 2, 3);
