// pi and the booleans
#version 3.7;
#debug concat(str(pi, 0, 6), "\n") // expect: 3.141593
#debug concat(str(true, 0, 6), "\n") // expect: 1.000000
#debug concat(str(false, 0, 6), "\n") // expect: 0.000000
#debug concat(str(yes, 0, 6), "\n") // expect: 1.000000
#debug concat(str(no, 0, 6), "\n") // expect: 0.000000
#debug concat(str(on, 0, 6), "\n") // expect: 1.000000
#debug concat(str(off, 0, 6), "\n") // expect: 0.000000
