// Macros of rand.inc
#version 3.7;
#include "rand.inc"
#declare R = seed(12);
#debug concat(str(RRand(5,10,R), 0, 6), "\n") // expect: 5.319414
#debug concat(str(SRand(R), 0, 6), "\n") // expect: 0.426508
#debug concat(vstr(3, VRand(R), ",", 0, 6), "\n") // expect: 0.250982,0.084146,0.384234
#debug concat(vstr(3, VRand_In_Box(<1,2,3>,<4,5,6>,R), ",", 0, 6), "\n") // expect: 3.261406,4.406726,3.612039
#debug concat(vstr(3, VRand_In_Sphere(R), ",", 0, 6), "\n") // expect: 0.322225,0.244474,-0.821275
#debug concat(vstr(3, VRand_On_Sphere(R), ",", 0, 6), "\n") // expect: 0.604850,-0.147449,-0.782570
#debug concat(str(Rand_Bernoulli(0.4,R), 0, 6), "\n") // expect: 1.000000
