// Golden values of geometric patterns
#version 3.7;
#macro Try(N, F) #debug concat(N, " ", str(F(0.1,0.2,0.3),0,6), " ", str(F(1.7,-0.4,2.6),0,6), " ", str(F(-3.25,0.75,0.5),0,6), "\n") #end
#declare F1 = function { pattern { boxed } } Try("boxed", F1)
#declare F2 = function { pattern { cylindrical } } Try("cylindrical", F2)
#declare F3 = function { pattern { planar } } Try("planar", F3)
#declare F4 = function { pattern { spherical } } Try("spherical", F4)
#declare F5 = function { pattern { onion } } Try("onion", F5)
#declare F6 = function { pattern { radial } } Try("radial", F6)
#declare F7 = function { pattern { quilted } } Try("quilted", F7)
#declare F8 = function { pattern { spiral1 2 } } Try("spiral1", F8)
#declare F9 = function { pattern { spiral2 2 } } Try("spiral2", F9)
#declare F10 = function { pattern { brick } } Try("brick", F10)
#declare F11 = function { pattern { cubic } } Try("cubic", F11)
#declare F12 = function { pattern { mandel 30 } } Try("mandel", F12)
#declare F13 = function { pattern { julia <0.3,0.5>, 20 } } Try("julia", F13)

// expect: boxed 0.700000 0.000000 0.000000
// expect: cylindrical 0.683772 0.000000 0.000000
// expect: planar 0.800000 0.600000 0.250000
// expect: spherical 0.625834 0.000000 0.000000
// expect: onion 0.374166 0.132092 0.372684
// expect: radial 0.801208 0.842163 0.524295
// expect: quilted 0.312365 0.087687 0.140461
// expect: spiral1 0.752026 0.454347 0.526347
// expect: spiral2 0.398500 0.077166 0.394539
// expect: brick 1.000000 0.000000 1.000000
// expect: cubic 2.000000 2.000000 3.000000
// expect: mandel 1.000000 0.000000 0.000000
// expect: julia 1.000000 0.000000 0.000000
