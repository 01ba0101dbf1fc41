// #ifdef, #ifndef, with #elseif
#version 3.7;
#declare A = 1;
#ifdef (A) #debug "A\n" #end
#ifndef (B) #debug "no B\n" #end
#ifdef (B) #debug "B\n" #elseif (A=1) #debug "else A\n" #else #debug "neither\n" #end

// expect: A
// expect: no B
// expect: else A
