// A mixture of expressions and string functions
#version 3.7;
#declare A = array[2] {x, y}
#declare V = <1,2,3>;
#debug concat(str((V.x > 0 ? A[1].y : 3), 0, 2), " ", str(!0*5, 0, 0), " ", str((1|0&0), 0, 0), "\n")
#declare deprecated once "old thing" Old = 3;
#debug concat(str(Old + Old, 0, 0), "\n")
#declare S = "a\tb\\c\"d\u0041";
#debug concat(S, " ", str(strlen(S), 0, 0), "\n")
#switch (2.5) #range (2, 3) #debug "range\n" #case (9) #debug "nine\n" #break #else #debug "else\n" #end
#declare T = transform { rotate 90*y translate x }
#declare F = function { transform { T } }
#debug concat(vstr(3, F(1, 2, 3), ",", 0, 3), "\n")
#debug concat(str(select(-0.5, 1, 2, 3), 0, 0), str(div(-7, 2), 3, 0), str(mod(-7, 3), 3, 0), "\n")
#debug concat(datetime(0), " ", datetime(8000.5, "%Y/%m/%d %H"), "\n")
#local I = 0; #while (true) #local I = I + 1; #if (I > 3) #break #end #end
#debug concat(str(I, 0, 0), "\n")
#debug concat(vstr(4, <1,2>*<3,4,5,6>, " ", 4, 1), "|", str(-3.14159, -9, 2), "|\n")
#debug concat(str(asc("Z"), 0, 0), chr(97), strupr("abc"), substr("hello", 2, 3), str(val("12abc"), 3, 0), "\n")
// expect: 1.00 5 0
// expect: 6
// expect: a	b\c"dA 8
// expect: range
// expect: nine
// expect: 4.000,2.000,-1.000
// expect: 1 -3 -1
// expect: 2000-01-01 00:00:00Z 2021/11/26 12
// expect: 4
// expect:  3.0  8.0  0.0  0.0|-00003.14|
// expect: 90aABCell 12
