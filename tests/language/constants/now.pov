// now is a number of days
#version 3.7;
#if (now > 9000) #debug "later than 2024\n" #end

// expect: later than 2024
