// Conditions are true above 1e-10
#version 3.7;
#if (-1) #debug "minus one\n" #end
#if (1e-11) #debug "tiny\n" #else #debug "not tiny\n" #end
#if (1e-9) #debug "small\n" #end
#if (0) #debug "zero\n" #end
#if (!1=0) #debug "not one is zero\n" #end

// expect: minus one
// expect: not tiny
// expect: small
// expect: not one is zero
