// The local. and global. name spaces
// only: minipov
#version 3.8;
#declare A = 1;
#macro M() #local A = 2; global.A + local.A*10 #end
#debug concat(str(M(), 0, 6), "\n")
// expect: 21.000000
