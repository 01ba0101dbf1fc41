// An include file restores the version
#version 3.7;
#include "colors.inc"
#debug concat(str(version, 0, 6), "\n") // expect: 3.700000
