// Arms may differ in size
#version 3.7;
#debug concat(vstr(3, (1?2:<1,2,3>), ",", 0, 6), "\n") // expect: 2.000000,0.000000,0.000000
#debug concat(vstr(3, (0?2:<1,2,3>), ",", 0, 6), "\n") // expect: 1.000000,2.000000,3.000000
#declare A = (1?5:<1,2,3>);
#debug concat(str(A, 0, 6), "\n") // expect: 5.000000
