// ?: chains to the right
#version 3.7;
#debug concat(str((0?1:2), 0, 6), "\n") // expect: 2.000000
#debug concat(str((0?1:1?2:3), 0, 6), "\n") // expect: 2.000000
#debug concat(str((1?(0?4:5):6), 0, 6), "\n") // expect: 5.000000
#debug concat(str((2>1 ? 10 : 20), 0, 6), "\n") // expect: 10.000000
#debug concat(vstr(3, (1?<1,2,3>:0), ",", 0, 6), "\n") // expect: 1.000000,2.000000,3.000000
