// Distributions of rand.inc
#version 3.7;
#include "rand.inc"
#declare R = seed(99);
#debug concat(str(Rand_Normal(5,2,R), 0, 6), "\n") // expect: 5.007761
#debug concat(str(Rand_Gauss(5,2,R), 0, 6), "\n") // expect: 0.253704
#debug concat(str(Rand_Exp(2,R), 0, 6), "\n") // expect: 0.108284
#debug concat(str(Rand_Poisson(3,R), 0, 6), "\n") // expect: 4.000000
#debug concat(str(Rand_Gamma(2,1,R), 0, 6), "\n") // expect: 0.410596
