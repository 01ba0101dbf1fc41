// What is not SDL does no harm in a branch that is not taken, after #break, and in a macro that is not called
#version 3.7;
#if (0)
    don't read this: sphere { <1, 2 #declare = ] pigment { rgb (1 } & 3.x
#else
    #debug "one\n" // expect: one
#end
#switch (1)
    #case (1) #debug "two\n" #break // expect: two
    #case (2): #debug "never\n" #break
    #default: #debug "never\n"
#end
#switch (1)
    #case (1) #debug "three\n" #break #default: #break // expect: three
#end
#macro Unused(A)
    #declare = A (
#end
#if (1)
    #if (0) <1, #foo #end #debug "four\n" // expect: four
#end
