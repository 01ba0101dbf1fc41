// Empty strings
#version 3.7;
#declare E = "";
#debug concat(str(strlen(E), 0, 6), "\n") // expect: 0.000000
#debug concat(concat("<", E, ">"), "\n") // expect: <>
#debug concat(str((E = ""), 0, 6), "\n") // expect: 1.000000
