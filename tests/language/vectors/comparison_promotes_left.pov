// Relations promote the left operand to the right's size
#version 3.7;
#debug concat(vstr(3, (1 < <0,1,2>), ",", 0, 6), "\n") // expect: 0.000000,0.000000,1.000000
#debug concat(str((<1,2,3> > 0).x, 0, 6), "\n") // expect: 1.000000
