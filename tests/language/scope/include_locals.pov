// #local in an include file ends with the file
#version 3.7;
#include "locals.inc"
#debug concat(str(Shared, 0, 6), "\n") // expect: 2.000000
#debug concat(str(defined(Hidden), 0, 6), "\n") // expect: 0.000000
#debug concat(str(Seen(), 0, 6), "\n") // expect: 3.000000
