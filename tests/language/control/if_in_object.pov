// Directives between the items of an object
#version 3.7;
#declare Big = 1;
#declare S = sphere { 0, #if (Big) 5 #else 1 #end translate #if (Big) x #else y #end }
#debug concat(vstr(3, max_extent(S), ",", 0, 6), "\n") // expect: 6.000000,5.000000,5.000000
