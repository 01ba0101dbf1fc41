// #undef of a macro
#version 3.7;
#macro M() 1 #end
#debug concat(str(defined(M), 0, 6), "\n") // expect: 1.000000
#undef M
#debug concat(str(defined(M), 0, 6), "\n") // expect: 0.000000
