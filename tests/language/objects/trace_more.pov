// trace of a box, a plane, a torus and a union
#version 3.7;
#declare B = box{-1,1 rotate 30*y}
#declare N = 0*x;
#debug concat(vstr(3, trace(B,<0.2,0.3,-5>,z,N), ",", 0, 6), "\n") // expect: 0.200000,0.300000,-1.270171
#debug concat(vstr(3, N, ",", 0, 6), "\n") // expect: -0.500000,0.000000,-0.866025
#declare P = plane{<0,1,1>,1}
#debug concat(vstr(3, trace(P,<0,5,0>,-y,N), ",", 0, 6), "\n") // expect: 0.000000,1.414214,0.000000
#debug concat(vstr(3, N, ",", 0, 6), "\n") // expect: 0.000000,0.707107,0.707107
#declare T = torus{2,0.5}
#debug concat(vstr(3, trace(T,<1.8,5,0.3>,-y,N), ",", 0, 6), "\n") // expect: 1.800000,0.468311,0.300000
#debug concat(vstr(3, N, ",", 0, 6), "\n") // expect: -0.345576,0.936622,-0.057596
#declare U = union{sphere{0,1} cylinder{0,2*x,0.5}}
#debug concat(vstr(3, trace(U,<1.2,3,0.1>,-y,N), ",", 0, 6), "\n") // expect: 1.200000,0.489898,0.100000
#debug concat(vstr(3, N, ",", 0, 6), "\n") // expect: 0.000000,0.979796,0.200000
