// Equality allows a difference of 1e-10
#version 3.7;
#debug concat(str((1 = 1.00000000001), 0, 6), "\n") // expect: 1.000000
#debug concat(str((1 = 1.000000001), 0, 6), "\n") // expect: 0.000000
#debug concat(str((1 != 1.00000000001), 0, 6), "\n") // expect: 0.000000
#debug concat(str((1 <= 0.99999999999), 0, 6), "\n") // expect: 1.000000
#debug concat(str((1 >= 1.00000000001), 0, 6), "\n") // expect: 1.000000
#debug concat(str((1 < 1.00000000001), 0, 6), "\n") // expect: 1.000000
#debug concat(str((1 > 0.99999999999), 0, 6), "\n") // expect: 1.000000
