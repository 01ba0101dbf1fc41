// inside of solids
#version 3.7;
#declare S = sphere{0,1}
#debug concat(str(inside(S,<0.5,0,0>), 0, 6), "\n") // expect: 1.000000
#debug concat(str(inside(S,<1.5,0,0>), 0, 6), "\n") // expect: 0.000000
#declare D = difference{box{-1,1} sphere{0,0.9}}
#debug concat(str(inside(D,<0,0,0>), 0, 6), "\n") // expect: 0.000000
#debug concat(str(inside(D,<0.95,0.95,0>), 0, 6), "\n") // expect: 1.000000
#declare P = plane{y,0}
#debug concat(str(inside(P,-y), 0, 6), "\n") // expect: 1.000000
#debug concat(str(inside(P,y), 0, 6), "\n") // expect: 0.000000
#declare I = sphere{0,1 inverse}
#debug concat(str(inside(I,0), 0, 6), "\n") // expect: 0.000000
