// select by sign, with and without the zero case
#version 3.7;
#debug concat(str(select(-1,10,20), 0, 6), "\n") // expect: 10.000000
#debug concat(str(select(0,10,20), 0, 6), "\n") // expect: 20.000000
#debug concat(str(select(1,10,20), 0, 6), "\n") // expect: 20.000000
#debug concat(str(select(0,10,20,30), 0, 6), "\n") // expect: 20.000000
#debug concat(str(select(5,10,20,30), 0, 6), "\n") // expect: 30.000000
#debug concat(str(select(-5,10,20,30), 0, 6), "\n") // expect: 10.000000
#debug concat(str(select(1e-11,10,20,30), 0, 6), "\n") // expect: 30.000000
