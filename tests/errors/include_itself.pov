// A file that includes itself
// error: 4:10 include
#version 3.7;
#include "include_itself.pov"
