// Functions, strings, vectors, arrays and objects as arguments
#version 3.7;
#macro Call(F, A) F(A,0,0) #end
#declare Sq = function { x*x }
#debug concat(str(Call(Sq, 3), 0, 6), "\n") // expect: 9.000000
#macro Len(S) strlen(S) #end
#debug concat(str(Len("four"), 0, 6), "\n") // expect: 4.000000
#macro Top(O) max_extent(O) #end
#declare Ball = sphere{0,3}
#debug concat(vstr(3, Top(Ball), ",", 0, 6), "\n") // expect: 3.000000,3.000000,3.000000
#macro Second(V) V.y #end
#debug concat(str(Second(<1,2,3>), 0, 6), "\n") // expect: 2.000000
