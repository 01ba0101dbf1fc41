// Strings in identifiers and as arguments
#version 3.7;
#declare S = "left";
#declare T = concat(S, "-right");
#macro Shout(A) strupr(A) #end
#debug concat(T, "\n") // expect: left-right
#debug concat(Shout(T), "\n") // expect: LEFT-RIGHT
