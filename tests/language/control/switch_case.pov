// #switch with #case and #break
#version 3.7;
#macro Name(N) #switch (N) #case (1) "one" #break #case (2) "two" #break #else "many" #end #end
#debug concat(Name(1), "\n")
#debug concat(Name(2), "\n")
#debug concat(Name(7), "\n")

// expect: one
// expect: two
// expect: many
