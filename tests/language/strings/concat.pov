// concat joins any number of strings
#version 3.7;
#debug concat(concat("a","b","c"), "\n") // expect: abc
#debug concat(concat("only"), "\n") // expect: only
#debug concat(concat("", "x", ""), "\n") // expect: x
