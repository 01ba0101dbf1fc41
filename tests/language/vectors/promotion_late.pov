// A float becomes a vector only where one is needed
#version 3.7;
#declare A = 2;
#debug concat(str(A*2, 0, 6), "\n") // expect: 4.000000
#debug concat(str(vlength(2), 0, 6), "\n") // expect: 3.464102
#debug concat(str(vdot(2,<1,2,3>), 0, 6), "\n") // expect: 12.000000
#debug concat(vstr(3, vcross(1,<1,2,3>), ",", 0, 6), "\n") // expect: 1.000000,-2.000000,1.000000
