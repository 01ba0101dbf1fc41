// Component names, by position or by colour
#version 3.7;
#declare V = <1,2,3,4,5>;
#debug concat(str(V.x, 0, 6), "\n") // expect: 1.000000
#debug concat(str(V.y, 0, 6), "\n") // expect: 2.000000
#debug concat(str(V.z, 0, 6), "\n") // expect: 3.000000
#debug concat(str(V.t, 0, 6), "\n") // expect: 4.000000
#debug concat(str(V.transmit, 0, 6), "\n") // expect: 5.000000
#debug concat(str(V.red, 0, 6), "\n") // expect: 1.000000
#debug concat(str(V.green, 0, 6), "\n") // expect: 2.000000
#debug concat(str(V.blue, 0, 6), "\n") // expect: 3.000000
#debug concat(str(V.filter, 0, 6), "\n") // expect: 4.000000
#debug concat(str(V.u, 0, 6), "\n") // expect: 1.000000
#debug concat(str(V.v, 0, 6), "\n") // expect: 2.000000
