// Several lines in one text
#version 3.7;
#debug "a\nb\n\nc\n"

// expect: a
// expect: b
// expect:
// expect: c
