// A handle is defined while it is open
#version 3.7;
#fopen F "handle.txt" write
#debug concat(str(defined(F), 0, 6), "\n")
#fclose F
#debug concat(str(defined(F), 0, 6), "\n")
#ifdef (F) #debug "open\n" #else #debug "closed\n" #end

// expect: 1.000000
// expect: 0.000000
// expect: closed
