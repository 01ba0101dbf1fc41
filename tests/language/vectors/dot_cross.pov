// vdot, vcross, vlength, vnormalize
#version 3.7;
#debug concat(str(vdot(<1,2,3>,<4,-5,6>), 0, 6), "\n") // expect: 12.000000
#debug concat(vstr(3, vcross(x,y), ",", 0, 6), "\n") // expect: 0.000000,0.000000,1.000000
#debug concat(vstr(3, vcross(<1,2,3>,<3,2,1>), ",", 0, 6), "\n") // expect: -4.000000,8.000000,-4.000000
#debug concat(str(vlength(<3,4,12>), 0, 6), "\n") // expect: 13.000000
#debug concat(vstr(3, vnormalize(<3,0,4>), ",", 0, 6), "\n") // expect: 0.600000,0.000000,0.800000
