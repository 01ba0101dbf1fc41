// #declare copies
#version 3.7;
#declare A = sphere{0,1}
#declare B = object{A translate 2*x}
#debug concat(vstr(3, max_extent(A), ",", 0, 6), "\n") // expect: 1.000000,1.000000,1.000000
#debug concat(vstr(3, max_extent(B), ",", 0, 6), "\n") // expect: 3.000000,1.000000,1.000000
