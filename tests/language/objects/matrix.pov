// matrix
#version 3.7;
#declare B = box{0,1 matrix <2,0,0, 0,1,0, 0,0,1, 5,6,7>}
#debug concat(vstr(3, min_extent(B), ",", 0, 6), "\n") // expect: 5.000000,6.000000,7.000000
#debug concat(vstr(3, max_extent(B), ",", 0, 6), "\n") // expect: 7.000000,7.000000,8.000000
