// An older version
#version 3.1;
#debug concat(str(version, 0, 6), "\n") // expect: 3.100000
