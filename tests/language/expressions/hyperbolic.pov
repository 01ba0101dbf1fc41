// Hyperbolic functions and their inverses
#version 3.7;
#debug concat(str(sinh(1), 0, 6), "\n") // expect: 1.175201
#debug concat(str(cosh(1), 0, 6), "\n") // expect: 1.543081
#debug concat(str(tanh(1), 0, 6), "\n") // expect: 0.761594
#debug concat(str(asinh(1), 0, 6), "\n") // expect: 0.881374
#debug concat(str(acosh(2), 0, 6), "\n") // expect: 1.316958
#debug concat(str(atanh(0.5), 0, 6), "\n") // expect: 0.549306
