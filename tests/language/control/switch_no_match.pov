// A #switch without a match does nothing
#version 3.7;
#switch (9) #case (1) #debug "one\n" #break #end
#debug "done\n"

// expect: done
