// Component keywords in any order
#version 3.7;
#declare C = color red 0.3 blue 0.5;
#debug concat(vstr(5, C, ",", 0, 6), "\n") // expect: 0.300000,0.000000,0.500000,0.000000,0.000000
#declare D = colour green 0.2 transmit 0.5 red 1;
#debug concat(vstr(5, D, ",", 0, 6), "\n") // expect: 1.000000,0.200000,0.000000,0.000000,0.500000
#declare E = rgb 1 transmit 0.5;
#debug concat(vstr(5, E, ",", 0, 6), "\n") // expect: 1.000000,1.000000,1.000000,0.000000,0.500000
#declare F = color E red 0.25;
#debug concat(vstr(5, F, ",", 0, 6), "\n") // expect: 0.250000,1.000000,1.000000,0.000000,0.500000
