// Nested string functions
#version 3.7;
#debug concat(strupr(substr(concat("abc","def"),3,2)), "\n") // expect: CD
#debug concat(str(strlen(concat(str(1,5,1),str(22,0,0))), 0, 6), "\n") // expect: 7.000000
#debug concat(str(val(concat("1","2"))+1, 0, 6), "\n") // expect: 13.000000
