// The box of a rotated object is not tight
#version 3.7;
#declare B = box{-1,1 rotate 45*y}
#debug concat(vstr(3, max_extent(B), ",", 0, 6), "\n") // expect: 1.414214,1.000000,1.414214
#declare S = sphere{0,1 rotate 45*y scale <2,1,1>}
#debug concat(vstr(3, max_extent(S), ",", 0, 6), "\n") // expect: 2.000000,1.000000,1.000000
#declare C = cylinder{0,<1,2,3>,0.5}
#debug concat(vstr(3, min_extent(C), ",", 0, 6), "\n") // expect: -0.680178,-0.581070,-0.400892
#debug concat(vstr(3, max_extent(C), ",", 0, 6), "\n") // expect: 1.680178,2.581070,3.400892
