// str rounds as C does; a negative precision means six
#version 3.7;
#debug concat(str(2.5,0,0), "\n") // expect: 2
#debug concat(str(3.5,0,0), "\n") // expect: 4
#debug concat(str(1/3,0,-1), "\n") // expect: 0.333333
#debug concat(str(1/3,0,15), "\n") // expect: 0.333333333333333
#debug concat(str(0.125,0,2), "\n") // expect: 0.12
#debug concat(str(-0.4,0,0), "\n") // expect: -0
