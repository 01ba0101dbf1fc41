// #declare inside a macro makes a global, #local does not
#version 3.7;
#macro M() #declare NewGlobal = 5; #local NewLocal = 6; #end
M()
#debug concat(str(NewGlobal, 0, 6), "\n") // expect: 5.000000
#debug concat(str(defined(NewLocal), 0, 6), "\n") // expect: 0.000000
