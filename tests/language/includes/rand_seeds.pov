// Random points inside an object
#version 3.7;
#include "rand.inc"
#declare R = seed(5);
#declare Ball = sphere{<1,0,0>,1}
#debug concat(vstr(3, VRand_In_Obj(Ball, R), ",", 0, 6), "\n") // expect: 0.219906,0.138703,-0.333600
#debug concat(vstr(3, VRand_In_Obj(Ball, R), ",", 0, 6), "\n") // expect: 1.507889,-0.118405,-0.500449
