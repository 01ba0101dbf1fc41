// Declared transforms
#version 3.7;
#declare T = transform { scale 2 translate x }
#declare S = sphere{0,1 transform{T}}
#debug concat(vstr(3, max_extent(S), ",", 0, 6), "\n") // expect: 3.000000,2.000000,2.000000
#declare R = sphere{0,1 transform{T inverse}}
#debug concat(vstr(3, max_extent(R), ",", 0, 6), "\n") // expect: 0.000000,0.500000,0.500000
#declare Q = sphere{0,1 transform T}
#debug concat(vstr(3, max_extent(Q), ",", 0, 6), "\n") // expect: 3.000000,2.000000,2.000000
