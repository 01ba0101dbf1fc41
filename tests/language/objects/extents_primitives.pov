// Extents of other primitives
#version 3.7;
#declare C = cylinder{<0,0,0>,<0,3,0>,1}
#debug concat(vstr(3, min_extent(C), ",", 0, 6), "\n") // expect: -1.000000,0.000000,-1.000000
#debug concat(vstr(3, max_extent(C), ",", 0, 6), "\n") // expect: 1.000000,3.000000,1.000000
#declare K = cone{<0,0,0>,2,<0,3,0>,1}
#debug concat(vstr(3, max_extent(K), ",", 0, 6), "\n") // expect: 2.000000,3.000000,2.000000
#declare T = torus{2,0.5}
#debug concat(vstr(3, max_extent(T), ",", 0, 6), "\n") // expect: 2.500000,0.500000,2.500000
#declare P = plane{y,0}
#debug concat(vstr(3, max_extent(P), ",", 0, 6), "\n") // expect: 10000000000.000000,10000000000.000000,10000000000.000000
#declare D = disc{<0,0,0>,y,3}
#debug concat(vstr(3, max_extent(D), ",", 0, 6), "\n") // expect: 3.000000,0.001000,3.000000
