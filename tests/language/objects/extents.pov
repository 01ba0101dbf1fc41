// min_extent and max_extent
#version 3.7;
#declare S = sphere{<1,2,3>,2}
#debug concat(vstr(3, min_extent(S), ",", 0, 6), "\n") // expect: -1.000000,0.000000,1.000000
#debug concat(vstr(3, max_extent(S), ",", 0, 6), "\n") // expect: 3.000000,4.000000,5.000000
#declare B = box{<1,2,3>,<-1,5,0> translate x}
#debug concat(vstr(3, min_extent(B), ",", 0, 6), "\n") // expect: 0.000000,2.000000,0.000000
#debug concat(vstr(3, max_extent(B), ",", 0, 6), "\n") // expect: 2.000000,5.000000,3.000000
