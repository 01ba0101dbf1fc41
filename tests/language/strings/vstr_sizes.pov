// vstr clips its count and pads short vectors with zeros
#version 3.7;
#debug concat(vstr(3,2,",",0,1), "\n") // expect: 2.0,0.0,0.0
#debug concat(vstr(4,<1,2>,",",0,1), "\n") // expect: 1.0,2.0,0.0,0.0
#debug concat(vstr(2,<1,2,3,4>,",",0,1), "\n") // expect: 1.0,2.0
#debug concat(vstr(1,<1,2,3>,",",0,1), "\n") // expect: 1.0,2.0
#debug concat(vstr(9,<1,2,3>,",",0,1), "\n") // expect: 1.0,2.0,3.0,0.0,0.0
