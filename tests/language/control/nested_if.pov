// Nested conditions
#version 3.7;
#declare A = 1; #declare B = 0;
#if (A) #if (B) #debug "both\n" #else #debug "only A\n" #end #else #debug "none\n" #end

// expect: only A
