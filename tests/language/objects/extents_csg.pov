// Extents of CSG
#version 3.7;
#declare U = union{sphere{0,1} box{<2,2,2>,<3,3,3>}}
#debug concat(vstr(3, min_extent(U), ",", 0, 6), "\n") // expect: -1.000000,-1.000000,-1.000000
#debug concat(vstr(3, max_extent(U), ",", 0, 6), "\n") // expect: 3.000000,3.000000,3.000000
#declare I = intersection{box{-2,2} box{0,5}}
#debug concat(vstr(3, min_extent(I), ",", 0, 6), "\n") // expect: 0.000000,0.000000,0.000000
#debug concat(vstr(3, max_extent(I), ",", 0, 6), "\n") // expect: 2.000000,2.000000,2.000000
#declare D = difference{box{-2,2} box{<0,-3,-3>,<3,3,3>}}
#debug concat(vstr(3, min_extent(D), ",", 0, 6), "\n") // expect: -2.000000,-2.000000,-2.000000
#debug concat(vstr(3, max_extent(D), ",", 0, 6), "\n") // expect: 2.000000,2.000000,2.000000
