// vrotate turns x, then y, then z, left-handed
#version 3.7;
#debug concat(vstr(3, vrotate(x,<0,90,0>), ",", 0, 6), "\n") // expect: 0.000000,0.000000,-1.000000
#debug concat(vstr(3, vrotate(x,<0,0,90>), ",", 0, 6), "\n") // expect: 0.000000,1.000000,0.000000
#debug concat(vstr(3, vrotate(y,<90,0,0>), ",", 0, 6), "\n") // expect: 0.000000,0.000000,1.000000
#debug concat(vstr(3, vrotate(<1,2,3>,<10,20,30>), ",", 0, 6), "\n") // expect: 1.067425,2.289059,2.760581
