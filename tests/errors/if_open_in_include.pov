// An include file that ends inside #if
// error: open_if.inc:2:1 #end
#version 3.7;
#include "open_if.inc"
