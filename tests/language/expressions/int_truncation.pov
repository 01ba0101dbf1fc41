// int, div and subscripts truncate toward zero
#version 3.7;
#debug concat(str(int(-2.7), 0, 6), "\n") // expect: -2.000000
#debug concat(str(int(2.7), 0, 6), "\n") // expect: 2.000000
#debug concat(str(floor(-2.7), 0, 6), "\n") // expect: -3.000000
#debug concat(str(ceil(-2.7), 0, 6), "\n") // expect: -2.000000
#debug concat(str(div(-7,2), 0, 6), "\n") // expect: -3.000000
#debug concat(str(div(7,2), 0, 6), "\n") // expect: 3.000000
#debug concat(str(div(7.9,2), 0, 6), "\n") // expect: 3.000000
