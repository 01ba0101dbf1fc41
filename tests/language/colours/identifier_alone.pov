// A colour identifier needs no keyword
#version 3.7;
#declare Warm = rgb <1,0.5,0.2>;
#declare Pale = Warm*0.5 + 0.5;
#debug concat(vstr(5, Pale, ",", 0, 6), "\n") // expect: 1.000000,0.750000,0.600000,0.500000,0.500000
#debug concat(str(Pale.gray, 0, 6), "\n") // expect: 0.807150
