// An identifier as the first item is the whole object
#version 3.7;
#declare S = union{ sphere{0,1} sphere{5*x,1} }
#declare U = union { S translate 3*y }
#debug concat(vstr(3, max_extent(U), ",", 0, 6), "\n") // expect: 6.000000,4.000000,1.000000
