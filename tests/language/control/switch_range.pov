// #range is inclusive and runs on into #else
#version 3.7;
#macro R(N) #switch (N) #range (1,3) #debug "range " #else #debug "else " #end #debug "\n" #end
R(1)
R(3)
R(4)
R(2.5)

// expect: range else
// expect: range else
// expect: else
// expect: range else
