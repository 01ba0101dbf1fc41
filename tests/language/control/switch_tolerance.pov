// #case allows 1e-10
#version 3.7;
#switch (1.00000000001) #case (1) #debug "equal\n" #break #else #debug "different\n" #end
#switch (1.000000001) #case (1) #debug "equal\n" #break #else #debug "different\n" #end

// expect: equal
// expect: different
