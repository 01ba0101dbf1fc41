// Text without a newline is held and joined
#version 3.7;
#debug "one "
#debug "two "
#debug "three\n"

// expect: one two three
