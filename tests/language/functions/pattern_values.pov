// Golden values of noise patterns
#version 3.7;
#macro Try(N, F) #debug concat(N, " ", str(F(0.1,0.2,0.3),0,6), " ", str(F(1.7,-0.4,2.6),0,6), " ", str(F(-3.25,0.75,0.5),0,6), "\n") #end
#declare F1 = function { pattern { agate } } Try("agate", F1)
#declare F2 = function { pattern { bozo } } Try("bozo", F2)
#declare F3 = function { pattern { granite } } Try("granite", F3)
#declare F4 = function { pattern { wrinkles } } Try("wrinkles", F4)
#declare F5 = function { pattern { crackle } } Try("crackle", F5)
#declare F6 = function { pattern { dents } } Try("dents", F6)
#declare F7 = function { pattern { marble turbulence 1 } } Try("marble", F7)
#declare F8 = function { pattern { wood turbulence 0.3 } } Try("wood", F8)
#declare F9 = function { pattern { leopard } } Try("leopard", F9)
#declare F10 = function { pattern { ripples } } Try("ripples", F10)
#declare F11 = function { pattern { waves } } Try("waves", F11)
#declare F12 = function { pattern { cells } } Try("cells", F12)

// expect: agate 0.223695 0.891555 0.833302
// expect: bozo 0.417192 0.610342 0.632453
// expect: granite 0.643654 0.076413 0.281072
// expect: wrinkles 0.500988 0.588991 0.720585
// expect: crackle 0.102800 0.185527 0.036085
// expect: dents 0.072612 0.227363 0.252979
// expect: marble 0.194672 0.274841 0.349047
// expect: wood 0.540517 0.018837 0.012806
// expect: leopard 0.039207 0.138818 0.179002
// expect: ripples 0.702900 0.500225 0.360075
// expect: waves 0.762867 0.345803 0.396006
// expect: cells 0.711819 0.337377 0.446347
