// mod has the sign of its first operand
#version 3.7;
#debug concat(str(mod(-7,3), 0, 6), "\n") // expect: -1.000000
#debug concat(str(mod(7,-3), 0, 6), "\n") // expect: 1.000000
#debug concat(str(mod(7.5,2), 0, 6), "\n") // expect: 1.500000
#debug concat(str(mod(-0.5,1), 0, 6), "\n") // expect: -0.500000
