// Operators inside a block of a macro's body stay there, also where the macro's own value joins its surroundings.
#version 3.7;
#macro Shifted(P) #local T = sphere { 0, 1 translate P*x + 2*y } max_extent(T).x - P #end
#debug concat(str(Shifted(2), 0, 3), "\n") // expect: 1.000
#debug concat(str(2*Shifted(2), 0, 3), "\n") // expect: 4.000
