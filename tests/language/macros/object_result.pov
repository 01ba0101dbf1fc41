// A macro that makes an object
#version 3.7;
#macro Ball(R) sphere{0,R} #end
#declare B = Ball(2)
#debug concat(vstr(3, max_extent(B), ",", 0, 6), "\n") // expect: 2.000000,2.000000,2.000000
#declare U = union { Ball(1) Ball(3) }
#debug concat(vstr(3, max_extent(U), ",", 0, 6), "\n") // expect: 3.000000,3.000000,3.000000
