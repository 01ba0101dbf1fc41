// vturbulence is fixed noise
#version 3.7;
#debug concat(vstr(3, vturbulence(2,0.5,6,<1.5,2.5,3.5>), ",", 0, 6), "\n") // expect: 0.069577,-0.038919,0.025033
#debug concat(vstr(3, vturbulence(3,0.7,3,<0.1,-2,5>), ",", 0, 6), "\n") // expect: 0.684714,-0.436131,0.436547
#debug concat(vstr(3, vturbulence(2,0.5,20,<1,2,3.3>), ",", 0, 6), "\n") // expect: -0.213181,-0.345246,0.391808
