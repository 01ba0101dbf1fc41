// The usual guard
#version 3.7;
#include "guarded.inc"
#include "guarded.inc"
#debug concat(str(Guarded_Count, 0, 6), "\n") // expect: 1.000000
