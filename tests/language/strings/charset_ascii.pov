// without a charset every byte beyond ASCII is a blank
#version 3.7;
#declare S = "aéö€b";
#debug concat(S, "|", str(strlen(S), 0, 0), "\n")
#debug concat(str(asc("\u00e9"), 0, 0), "\n")
#debug concat(str(strlen(chr(0)), 0, 0), " ", str(asc(chr(255)), 0, 0), "\n")
// expect: a       b|9
// expect: 233
// expect: 0 255
