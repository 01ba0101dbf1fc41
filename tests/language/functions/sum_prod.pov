// sum and prod
#version 3.7;
#declare F = function(n) { sum(i, 1, n, i*i) }
#debug concat(str(F(4), 0, 6), "\n") // expect: 30.000000
#declare G = function(n) { prod(i, 1, n, i) }
#debug concat(str(G(5), 0, 6), "\n") // expect: 120.000000
#declare H = function(n) { sum(i, 1, n, prod(j, 1, i, j)) }
#debug concat(str(H(4), 0, 6), "\n") // expect: 33.000000
#debug concat(str(F(0), 0, 6), "\n") // expect: 0.000000
