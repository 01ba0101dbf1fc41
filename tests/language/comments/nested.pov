// Block comments nest
#version 3.7;
/* outer /* inner */ still outer */
#debug "out\n" // line comment /* not opened // expect: out
#debug "end\n" /* one */ /* two */ // expect: end
