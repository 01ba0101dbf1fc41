// Objects by identifier, bare and in object{}
#version 3.7;
#declare S = sphere{0,1}
#declare U = union { object{S translate 3*x} S }
#debug concat(vstr(3, max_extent(U), ",", 0, 6), "\n") // expect: 4.000000,1.000000,1.000000
#declare B = box{S scale 2}
#debug concat(vstr(3, max_extent(B), ",", 0, 6), "\n") // expect: 2.000000,2.000000,2.000000
