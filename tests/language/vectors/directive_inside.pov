// Directives inside a vector
#version 3.7;
#declare K = 1;
#debug concat(vstr(3, <1, #if (K) 2 #else 20 #end, 3>, ",", 0, 6), "\n")
#debug concat(vstr(3, <#for (I, 1, 3) I, #end>, ",", 0, 6), "\n")

// expect: 1.000000,2.000000,3.000000
// expect: 1.000000,2.000000,3.000000
