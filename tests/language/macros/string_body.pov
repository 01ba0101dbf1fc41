// A macro that yields a string and a vector
#version 3.7;
#macro Name(N) concat("item", str(N,0,0)) #end
#debug concat(concat(Name(3), Name(4)), "\n") // expect: item3item4
#macro Pos(N) <N, N*2, 0> #end
#debug concat(vstr(3, Pos(2) + Pos(3)*2, ",", 0, 6), "\n") // expect: 8.000000,16.000000,0.000000
#debug concat(str(Pos(2).y, 0, 6), "\n") // expect: 4.000000
