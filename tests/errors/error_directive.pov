// #error halts
// error: 4:1 too few stars
#version 3.7;
#error "too few stars\n"
