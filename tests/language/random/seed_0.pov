// The stream of seed 0
#version 3.7;
#declare R = seed(0);
#debug concat(str(R, 0, 6), "\n") // expect: 0.000000
#debug concat(str(rand(R), 0, 6), "\n") // expect: 0.000003
#debug concat(str(rand(R), 0, 6), "\n") // expect: 0.466564
#debug concat(str(rand(R), 0, 6), "\n") // expect: 0.249070
