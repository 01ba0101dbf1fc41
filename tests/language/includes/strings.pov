// Macros of strings.inc
#version 3.7;
#include "strings.inc"
#debug concat(Str(3.5), "\n") // expect: 3.500000
#debug concat(VStr(<1,2,3>), "\n") // expect: <1.000000,2.000000,3.000000>
#debug concat(Vstr(<1,2,3>,0,1), "\n") // expect: <1.0,2.0,3.0>
#debug concat(VStr2D(<1,2>), "\n") // expect: <1.000000,2.000000>
#debug concat(CRGBStr(<1,0.5,0>,0,2), "\n") // expect: color rgb <   1.00, 0.50, 0.00>
#debug concat(substr(Triangle_Str(x,y,z),1,40), "\n") // expect: triangle {<1.000000,0.000000,0.000000>,<
Parse_String("#debug \"parsed\\n\"") // expect: parsed
