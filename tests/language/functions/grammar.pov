// & binds tighter than
#version 3.7;
#declare F = function(a,b,c) { a | b & c }
#debug concat(str(F(1,0,0), 0, 6), "\n") // expect: 1.000000
#declare G = function(a,b) { a < b }
#debug concat(str(G(1,2), 0, 6), "\n") // expect: 1.000000
#declare H = function(a) { a > 1 & a < 3 | a = 7 }
#debug concat(str(H(2), 0, 6), "\n") // expect: 1.000000
#debug concat(str(H(7), 0, 6), "\n") // expect: 1.000000
#debug concat(str(H(5), 0, 6), "\n") // expect: 0.000000
