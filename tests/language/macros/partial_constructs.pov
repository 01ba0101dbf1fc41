// A macro may be part of a construct
#version 3.7;
#macro Half() 1} #end
#declare S = sphere{0, Half()
#debug concat(vstr(3, max_extent(S), ",", 0, 6), "\n") // expect: 1.000000,1.000000,1.000000
#macro Nums() 1,2,3 #end
#debug concat(vstr(3, <Nums()>, ",", 0, 6), "\n") // expect: 1.000000,2.000000,3.000000
