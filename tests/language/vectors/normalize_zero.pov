// vnormalize of zero reports an error but goes on
#version 3.7;
#debug concat(vstr(3, vnormalize(<0,0,0>), ",", 0, 6), "\n") // expect: 0.000000,0.000000,0.000000
