// Component access binds tighter than signs
#version 3.7;
#declare V = <1,2,3>;
#debug concat(str(-V.y, 0, 6), "\n") // expect: -2.000000
#debug concat(str(<4,5,6>.z, 0, 6), "\n") // expect: 6.000000
#debug concat(str((x+2*y).y, 0, 6), "\n") // expect: 2.000000
#debug concat(str(V.x+V.z, 0, 6), "\n") // expect: 4.000000
#debug concat(str(!V.x, 0, 6), "\n") // expect: 0.000000
