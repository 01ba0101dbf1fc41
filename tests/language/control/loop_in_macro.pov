// A loop inside a macro, a macro inside a loop
#version 3.7;
#macro Row(N) #for (I, 1, N) #debug "*" #end #debug "\n" #end
#for (K, 1, 3) Row(K) #end

// expect: *
// expect: **
// expect: ***
