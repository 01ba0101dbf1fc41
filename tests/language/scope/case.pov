// Names are case sensitive
#version 3.7;
#declare Size = 1;
#declare SIZE = 2;
#debug concat(str(Size, 0, 6), "\n") // expect: 1.000000
#debug concat(str(SIZE, 0, 6), "\n") // expect: 2.000000
