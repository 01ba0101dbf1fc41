// Escape sequences
#version 3.7;
#debug "tab\tend\n"
#debug "quote \" and backslash \\ and ' \' \n"
#debug "two\nlines\n"
#debug "\u0041\u0062c\n"

// expect: tab	end
// expect: quote " and backslash \ and ' '
// expect: two
// expect: lines
// expect: Abc
