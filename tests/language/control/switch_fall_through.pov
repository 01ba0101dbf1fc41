// Without #break the next case runs too
#version 3.7;
#switch (1)
  #case (1) #debug "one "
  #case (2) #debug "two "
  #break
  #case (3) #debug "three "
#end
#debug "\n"

// expect: one two
