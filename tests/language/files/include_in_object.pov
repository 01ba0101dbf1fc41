// An include file may supply part of an object
#version 3.7;
#declare S = sphere { #include "part.inc" }
#debug concat(vstr(3, max_extent(S), ",", 0, 6), "\n") // expect: 10.000000,12.000000,14.000000
