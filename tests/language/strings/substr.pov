// substr counts from one
#version 3.7;
#debug concat(substr("abcdef",1,2), "\n") // expect: ab
#debug concat(substr("abcdef",3,4), "\n") // expect: cdef
#debug concat(substr("abcdef",6,1), "\n") // expect: f
