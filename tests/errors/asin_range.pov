// asin beyond 1 only warns
// warning: 4:14 asin
#version 3.7;
#declare A = asin(2);
