// A file may be included more than once
#version 3.7;
#declare Count = 0;
#include "count.inc"
#include "count.inc"
#debug concat(str(Count, 0, 6), "\n") // expect: 2.000000
