// Dictionaries by key and by name
// only: minipov
#version 3.8;
#declare D = dictionary { ["k"]: 5, .n: 6 }
#debug concat(str(D["k"], 0, 6), "\n")
#debug concat(str(D.n, 0, 6), "\n")
#ifdef (D.k) #debug "has k\n" #end
#ifndef (D.z) #debug "no z\n" #end
// expect: 5.000000
// expect: 6.000000
// expect: has k
// expect: no z
