// directives and macros that give parts of a function's body
#version 3.7;
#macro Sum() x + 1 #end
#declare F = function { 2*Sum() }
#debug concat(str(F(3, 0, 0), 0, 0), "\n")
#declare F1 = function { #if (1) x + #else y + #end z }
#debug concat(str(F1(3, 4, 5), 0, 0), "\n")
#declare F2 = function { 0 #declare I = 0; #while (I < 4) + pow(x, I) #declare I = I + 1; #end }
#debug concat(str(F2(3, 4, 5), 0, 0), "\n")
#declare F3 = function { x #for (K, 1, 3) + K*y #end }
#debug concat(str(F3(3, 4, 5), 0, 0), "\n")
#macro Rest(N) #local I = 0; #while (I < N) + I*x #local I = I + 1; #end #end
#declare F4 = function { y Rest(4) }
#debug concat(str(F4(3, 4, 5), 0, 0), "\n")
#declare F5 = function (a, b) { min(a #ifdef (F) , b #end) }
#debug concat(str(F5(4, 3), 0, 0), "\n")
#macro Times() * #end
#declare F6 = function { x Times() y + 1 }
#debug concat(str(F6(3, 4, 0), 0, 0), "\n")
#macro Point() x, y, z #end
#declare F7 = function { F4(Point()) }
#debug concat(str(F7(3, 4, 0), 0, 0), "\n")
#declare F8 = function { #switch (2) #case (1) x #break #case (2) y #break #end }
#debug concat(str(F8(3, 4, 0), 0, 0), "\n")
#macro Nested(N) #if (N = 0) x #else sin(Nested(N - 1)) #end #end
#declare F9 = function { Nested(3) }
#debug concat(str(F9(1, 4, 0), 0, 5), "\n")
#declare Factors = array[2] { 3, 4 }
#declare F10 = function { 0 #for (I, 0, 1) + Factors[I]*(x - I) #end }
#debug concat(str(F10(5, 0, 0), 0, 0), "\n")
#declare F11 = function (n) { #if (1) sum(i, 1, n, -i*i) & n > 2 | n = 1 #end }
#debug concat(str(F11(4), 0, 0), str(F11(1), 0, 0), str(F11(0), 0, 0), "\n")
#declare P = function { pigment { gradient x color_map { [0 rgb 0] [1 rgb <1, 2, 4>] } } }
#declare F12 = function { #if (1) P(x, 0, 0).green + P(y, 0, 0).gray #end }
#debug concat(str(F12(0.5, 0.25, 0), 0, 4), "\n")
// expect: 7
// expect: 8
// expect: 40
// expect: 27
// expect: 22
// expect: 3
// expect: 13
// expect: 22
// expect: 4
// expect: 0.67843
// expect: 31
// expect: 110
// expect: 1.4828
