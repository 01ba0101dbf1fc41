// A declared vector keeps its size
#version 3.7;
#declare A = <1,2>;
#declare B = A + 1;
#debug concat(vstr(3, A, ",", 0, 6), "\n") // expect: 1.000000,2.000000,0.000000
#debug concat(vstr(3, B, ",", 0, 6), "\n") // expect: 2.000000,3.000000,0.000000
#debug concat(vstr(2, A*A, ",", 0, 6), "\n") // expect: 1.000000,4.000000
