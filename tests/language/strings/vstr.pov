// vstr prints two to five components
#version 3.7;
#debug concat(vstr(3,<1,2,3>,", ",0,2), "\n") // expect: 1.00, 2.00, 3.00
#debug concat(vstr(2,<1,2,3>,"|",5,1), "\n") // expect:   1.0|  2.0
#debug concat(vstr(3,<1,2,3>,"",-5,1), "\n") // expect: 001.0002.0003.0
#debug concat(vstr(5,<1,2,3,4,5>,";",0,0), "\n") // expect: 1;2;3;4;5
