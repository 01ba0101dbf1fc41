// val reads a leading number
#version 3.7;
#debug concat(str(val("12.5"), 0, 6), "\n") // expect: 12.500000
#debug concat(str(val("abc"), 0, 6), "\n") // expect: 0.000000
#debug concat(str(val("1e2x"), 0, 6), "\n") // expect: 100.000000
#debug concat(str(val("-3.5"), 0, 6), "\n") // expect: -3.500000
#debug concat(str(val("  7"), 0, 6), "\n") // expect: 7.000000
#debug concat(str(val("+4"), 0, 6), "\n") // expect: 4.000000
