// Components of trace
#version 3.7;
#declare S = sphere{<0,1,0>,1}
#debug concat(str(trace(S,<0,5,0>,-y).y, 0, 6), "\n") // expect: 2.000000
