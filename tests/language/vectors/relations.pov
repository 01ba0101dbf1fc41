// Relations and logic by component
#version 3.7;
#debug concat(vstr(3, (<1,2,3> < <2,2,2>), ",", 0, 6), "\n") // expect: 1.000000,0.000000,0.000000
#debug concat(vstr(3, (<1,0,3> & <1,1,0>), ",", 0, 6), "\n") // expect: 1.000000,0.000000,0.000000
#debug concat(vstr(3, (!<1,0,2>), ",", 0, 6), "\n") // expect: 0.000000,1.000000,0.000000
#debug concat(vstr(3, (<0,0,1> | <0,1,0>), ",", 0, 6), "\n") // expect: 0.000000,1.000000,1.000000
