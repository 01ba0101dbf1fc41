// A ready stage, refractive indices, wood maps, standard camera
#version 3.7;
global_settings { assumed_gamma 1 }
#include "stage1.inc"
#include "ior.inc"
#include "woodmaps.inc"
#include "stdinc.inc"
#debug concat(str(iorDiamond, 0, 4), "\n")
#debug concat(str(defined(M_Wood1A), 0, 0), str(defined(M_Wood19B), 2, 0), str(defined(Pi), 2, 0), "\n")
// expect: 2.4170
// expect: 1 1 0
