// Forms of float literals
#version 3.7;
#debug concat(str(12, 0, 6), "\n") // expect: 12.000000
#debug concat(str(1., 0, 6), "\n") // expect: 1.000000
#debug concat(str(.5, 0, 6), "\n") // expect: 0.500000
#debug concat(str(1.e2, 0, 6), "\n") // expect: 100.000000
#debug concat(str(1E2, 0, 6), "\n") // expect: 100.000000
#debug concat(str(2e+1, 0, 6), "\n") // expect: 20.000000
#debug concat(str(3e-5, 0, 6), "\n") // expect: 0.000030
#debug concat(str(0012, 0, 6), "\n") // expect: 12.000000
