// A standard include file misspelt
// error: 5:10 'colours.inc'
// hint: did you mean 'colors.inc'
#version 3.7;
#include "colours.inc"
