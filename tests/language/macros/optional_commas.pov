// Commas between arguments are optional
#version 3.7;
#macro M(A,B) A-B #end
#debug concat(str(M(5 2), 0, 6), "\n") // expect: 3.000000
#debug concat(str(M(5, 2), 0, 6), "\n") // expect: 3.000000
