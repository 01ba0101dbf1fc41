// An empty macro leaves nothing behind
#version 3.7;
#macro Nothing() #end
Nothing()
#debug concat(str(1 Nothing() + 2, 0, 6), "\n") // expect: 3.000000
