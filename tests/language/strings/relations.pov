// Strings compare by code point
#version 3.7;
#debug concat(str(("abc" < "abd"), 0, 6), "\n")
#debug concat(str(("abc" = "abc"), 0, 6), "\n")
#debug concat(str(("abc" != "abd"), 0, 6), "\n")
#debug concat(str(("Z" < "a"), 0, 6), "\n")
#debug concat(str(("ab" < "abc"), 0, 6), "\n")
#if ("x" > "a") #debug "if\n" #end

// expect: 1.000000
// expect: 1.000000
// expect: 1.000000
// expect: 1.000000
// expect: 1.000000
// expect: if
