// Ten parameters
#version 3.7;
#macro M(A,B,C,D,E,F,G,H,I,J) A+B+C+D+E+F+G+H+I+J #end
#debug concat(str(M(1,2,3,4,5,6,7,8,9,10), 0, 6), "\n") // expect: 55.000000
