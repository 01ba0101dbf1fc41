// Constants inside functions
#version 3.7;
#declare F = function { pi*x + clock + 1e2 }
#debug concat(str(F(1,0,0), 0, 6), "\n") // expect: 103.141593
