// Division works on floats and by component
#version 3.7;
#debug concat(str(7/2, 0, 6), "\n") // expect: 3.500000
#debug concat(vstr(3, <8,6,4>/2, ",", 0, 6), "\n") // expect: 4.000000,3.000000,2.000000
#debug concat(vstr(3, <8,6,4>/<2,3,4>, ",", 0, 6), "\n") // expect: 4.000000,2.000000,1.000000
#debug concat(str(-1/4, 0, 6), "\n") // expect: -0.250000
