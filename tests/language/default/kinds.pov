// Default items of several kinds
#version 3.7;
#default { pigment { rgb x } finish { ambient 0.5 } }
#default { texture { pigment { rgb y } normal { bumps } } }
#default { finish { phong 1 } }
#debug "ok\n" // expect: ok
