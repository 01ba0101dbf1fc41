// str of infinities and tiny numbers
#version 3.7;
#debug concat(str(1/0,0,2), "\n") // expect: inf
#debug concat(str(-1/0,5,2), "\n") // expect:   inf
#debug concat(str(1e-20,0,3), "\n") // expect: 0.000
#debug concat(str(-1e-20,0,3), "\n") // expect: -0.000
#debug concat(str(1e20,0,1), "\n") // expect: 100000000000000000000.0
