// Semicolons are optional after declarations of objects
#version 3.7;
#declare S = sphere{0,1};
#declare T = sphere{0,2}
#debug concat(vstr(3, max_extent(T), ",", 0, 6), "\n") // expect: 2.000000,2.000000,2.000000
