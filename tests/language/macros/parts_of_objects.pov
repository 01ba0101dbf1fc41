// macros that open and close blocks, and give parts of them
#version 3.7;
#macro Open() union { #end
#macro Close() } #end
#macro Point(A) <A, A, A> #end
#macro Moved() scale 2 translate x #end
#macro Row(N) #local I = 0; #while (I < N) sphere { I, 1 } #local I = I + 1; #end #end
Open() sphere { 0, 1 } Close()
#declare U = union { sphere { 0, 1 } sphere { Point(2), 1 } Moved() }
#debug concat(vstr(3, max_extent(U), ",", 0, 2), "\n")
#declare U = union { Row(4) }
#debug concat(vstr(3, max_extent(U), ",", 0, 2), "\n")
object { Row(1) scale 2 }
// expect: 7.00,6.00,6.00
// expect: 4.00,4.00,4.00
