// Without #version
#debug concat(str(version, 0, 6), "\n") // expect: 3.700000
