// Texture libraries load
#version 3.7;
#include "colors.inc"
#include "textures.inc"
#include "metals.inc"
#include "golds.inc"
#include "glass.inc"
#include "stones.inc"
#include "woods.inc"
#include "skies.inc"
#include "stars.inc"
#include "finish.inc"
#debug concat(str(version, 0, 6), "\n") // expect: 3.700000
#debug concat(str(defined(Jade), 0, 6), "\n") // expect: 1.000000
#debug concat(str(defined(T_Wood7), 0, 6), "\n") // expect: 1.000000
#debug concat(str(defined(T_Gold_3C), 0, 6), "\n") // expect: 1.000000
#debug concat(str(defined(M_Glass3), 0, 6), "\n") // expect: 1.000000
