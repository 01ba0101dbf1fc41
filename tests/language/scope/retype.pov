// A name may change its type
#version 3.7;
#declare A = 1;
#debug concat(str(A, 0, 6), "\n") // expect: 1.000000
#declare A = <1,2,3>;
#debug concat(vstr(3, A, ",", 0, 6), "\n") // expect: 1.000000,2.000000,3.000000
#declare A = "text";
#debug concat(A, "\n") // expect: text
#declare A = sphere{0,1}
#debug concat(vstr(3, max_extent(A), ",", 0, 6), "\n") // expect: 1.000000,1.000000,1.000000
