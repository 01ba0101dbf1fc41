// The name of an include file is an expression
#version 3.7;
#declare Count = 0;
#declare Name = "cou";
#include concat(Name, "nt.inc")
#debug concat(str(Count, 0, 6), "\n") // expect: 1.000000
