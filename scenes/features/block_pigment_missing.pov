// a block pattern given fewer pigments than it has kinds of blocks: the others are the default pigment
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
#default { pigment { rgb <0.9, 0.4, 0.9> } }
camera { location <0, 2, -6> look_at 0 }
light_source { <-3, 6, -9>, 1 }
box { -1, 1 rotate <20, 30, 0> translate -2.2*x pigment { checker pigment { gradient y } scale 0.4 } }
box { -1, 1 rotate <20, 30, 0> pigment { hexagon pigment { rgb y } pigment { rgb z } scale 0.4 } }
box { -1, 1 rotate <20, 30, 0> translate 2.2*x pigment { hexagon rgb y scale 0.4 } }
