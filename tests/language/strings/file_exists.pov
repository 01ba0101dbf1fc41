// file_exists looks in the library paths
#version 3.7;
#debug concat(str(file_exists("colors.inc"), 0, 6), "\n") // expect: 1.000000
#debug concat(str(file_exists("no such file.inc"), 0, 6), "\n") // expect: 0.000000
