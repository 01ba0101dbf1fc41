// #declare changes the nearest binding of a name
#version 3.7;
#declare X1 = 1;
#macro M() #local X1 = 2; #declare X1 = 3; X1 #end
#debug concat(str(M(), 0, 6), "\n") // expect: 3.000000
#debug concat(str(X1, 0, 6), "\n") // expect: 1.000000
