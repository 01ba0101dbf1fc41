// The condition of ?: has the tolerance of #if
#version 3.7;
#debug concat(str((1e-11?1:2), 0, 6), "\n")
#debug concat(str((1e-9?1:2), 0, 6), "\n")
#debug concat(str((-1?1:2), 0, 6), "\n")

// expect: 2.000000
// expect: 1.000000
// expect: 1.000000
