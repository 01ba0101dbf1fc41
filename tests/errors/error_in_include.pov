// An error inside an include file
// error: broken.inc:3:19 'Nobody'
#version 3.7;
#include "broken.inc"
