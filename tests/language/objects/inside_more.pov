// inside of transformed objects
#version 3.7;
#declare C = cone{0,1,2*y,0 rotate 90*z}
#debug concat(str(inside(C,<-1,0.2,0>), 0, 6), "\n") // expect: 1.000000
#debug concat(str(inside(C,<1,0.2,0>), 0, 6), "\n") // expect: 0.000000
#declare T = torus{2,0.5 scale <1,2,1>}
#debug concat(str(inside(T,<2,0.9,0>), 0, 6), "\n") // expect: 1.000000
#debug concat(str(inside(T,0), 0, 6), "\n") // expect: 0.000000
#declare Q = quadric{<1,1,1>,0,0,-1}
#debug concat(str(inside(Q,<0.9,0,0>), 0, 6), "\n") // expect: 1.000000
