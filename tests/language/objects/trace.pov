// trace gives the first hit and the normal
#version 3.7;
#declare S = sphere{0,1}
#declare N = <9,9,9>;
#debug concat(vstr(3, trace(S,<0,0,-5>,z,N), ",", 0, 6), "\n") // expect: 0.000000,0.000000,-1.000000
#debug concat(vstr(3, N, ",", 0, 6), "\n") // expect: 0.000000,0.000000,-1.000000
#debug concat(vstr(3, trace(S,<0,5,-5>,z,N), ",", 0, 6), "\n") // expect: 0.000000,0.000000,0.000000
#debug concat(vstr(3, N, ",", 0, 6), "\n") // expect: 0.000000,0.000000,0.000000
