// vaxis_rotate turns about any axis
#version 3.7;
#debug concat(vstr(3, vaxis_rotate(x,z,90), ",", 0, 6), "\n") // expect: 0.000000,1.000000,0.000000
#debug concat(vstr(3, vaxis_rotate(<1,2,3>,<1,1,1>,120), ",", 0, 6), "\n") // expect: 3.000000,1.000000,2.000000
#debug concat(vstr(3, vaxis_rotate(<1,2,3>,<1,2,0>,33), ",", 0, 6), "\n") // expect: 2.461420,1.269290,2.516012
