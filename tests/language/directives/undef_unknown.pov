// #undef of an unknown name only warns
#version 3.7;
#undef Nothing_Here
#debug "ok\n" // expect: ok
