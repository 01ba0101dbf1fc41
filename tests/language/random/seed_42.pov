// The stream of seed 42
#version 3.7;
#declare R = seed(42);
#debug concat(str(rand(R), 0, 6), "\n") // expect: 0.723583
#debug concat(str(rand(R), 0, 6), "\n") // expect: 0.329979
