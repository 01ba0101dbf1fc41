// Arrays of vectors, strings and objects
#version 3.7;
#declare V = array[2] {<1,2,3>, <4,5,6>}
#declare S = array[2] {"one", "two"}
#declare O = array[1] {sphere{0,2}}
#debug concat(vstr(3, V[1], ",", 0, 6), "\n") // expect: 4.000000,5.000000,6.000000
#debug concat(str(V[0].y, 0, 6), "\n") // expect: 2.000000
#debug concat(S[1], "\n") // expect: two
#debug concat(vstr(3, max_extent(O[0]), ",", 0, 6), "\n") // expect: 2.000000,2.000000,2.000000
