// An include file that does not exist
// error: 4:10 'nowhere.inc'
#version 3.7;
#include "nowhere.inc"
