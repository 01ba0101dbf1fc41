// Components of colours
#version 3.7;
#declare C = rgbft <0.1,0.2,0.3,0.4,0.5>;
#debug concat(str(C.red, 0, 6), "\n") // expect: 0.100000
#debug concat(str(C.green, 0, 6), "\n") // expect: 0.200000
#debug concat(str(C.blue, 0, 6), "\n") // expect: 0.300000
#debug concat(str(C.filter, 0, 6), "\n") // expect: 0.400000
#debug concat(str(C.transmit, 0, 6), "\n") // expect: 0.500000
#declare R = C.red;
#debug concat(str(R*2, 0, 6), "\n") // expect: 0.200000
