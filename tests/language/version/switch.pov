// #version inside the file
#version 3.7;
#local Old = version;
#debug concat(str(version, 0, 6), "\n") // expect: 3.700000
#version 3.5;
#debug concat(str(version, 0, 6), "\n") // expect: 3.500000
#version Old;
#debug concat(str(version, 0, 6), "\n") // expect: 3.700000
