// The locals of a macro end with it, globals remain
#version 3.7;
#macro Outer() #local A = 1; Inner() #end
#macro Inner() #declare Seen = A; #declare Fresh = 2; #end
Outer()
#debug concat(str(Seen, 0, 6), "\n") // expect: 1.000000
#debug concat(str(Fresh, 0, 6), "\n") // expect: 2.000000
#debug concat(str(defined(A), 0, 6), "\n") // expect: 0.000000
