// Macros may call themselves
#version 3.7;
#macro Fact(N) #if (N<=1) 1 #else (N*Fact(N-1)) #end #end
#debug concat(str(Fact(5), 0, 6), "\n") // expect: 120.000000
#macro Fib(N) #if (N<2) N #else (Fib(N-1)+Fib(N-2)) #end #end
#debug concat(str(Fib(10), 0, 6), "\n") // expect: 55.000000
