// x, y, z, u, v and t and their sizes
#version 3.7;
#debug concat(vstr(3, x, ",", 0, 6), "\n") // expect: 1.000000,0.000000,0.000000
#debug concat(vstr(3, y, ",", 0, 6), "\n") // expect: 0.000000,1.000000,0.000000
#debug concat(vstr(3, z, ",", 0, 6), "\n") // expect: 0.000000,0.000000,1.000000
#debug concat(vstr(2, u, ",", 0, 6), "\n") // expect: 1.000000,0.000000
#debug concat(vstr(2, v, ",", 0, 6), "\n") // expect: 0.000000,1.000000
#debug concat(vstr(4, t, ",", 0, 6), "\n") // expect: 0.000000,0.000000,0.000000,1.000000
#debug concat(vstr(3, x+2*y-z, ",", 0, 6), "\n") // expect: 1.000000,2.000000,-1.000000
