// exp, ln, log, pow and sqrt
#version 3.7;
#debug concat(str(exp(1), 0, 6), "\n") // expect: 2.718282
#debug concat(str(ln(10), 0, 6), "\n") // expect: 2.302585
#debug concat(str(log(1000), 0, 6), "\n") // expect: 3.000000
#debug concat(str(pow(2,10), 0, 6), "\n") // expect: 1024.000000
#debug concat(str(pow(2,-0.5), 0, 6), "\n") // expect: 0.707107
#debug concat(str(pow(-2,3), 0, 6), "\n") // expect: -8.000000
#debug concat(str(sqrt(2), 0, 6), "\n") // expect: 1.414214
