// A cylinder of no length
// error: 4:12 cylinder
#version 3.7;
cylinder { y, y, 1 }
