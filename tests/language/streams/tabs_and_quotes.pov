// Escapes in debug text
#version 3.7;
#debug "a\tb \"c\" \\ d\n" // expect: a	b "c" \ d
