// Statistics of math.inc
#version 3.7;
#include "math.inc"
#declare A = array[5] {1,2,3,4,10}
#debug concat(str(Mean(A), 0, 6), "\n") // expect: 4.000000
#debug concat(str(Std_Dev(A, Mean(A)), 0, 6), "\n") // expect: 3.162278
