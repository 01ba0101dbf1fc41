// tau is 2 pi
// only: minipov
#version 3.8;
#debug concat(str(tau, 0, 6), "\n")
// expect: 6.283185
