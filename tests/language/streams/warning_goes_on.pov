// #warning does not stop the scene
#version 3.7;
#warning "careful\n"
#debug "still here\n" // expect: still here
