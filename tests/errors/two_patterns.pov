// Two patterns in one pigment
// error: 4:32 'wood'
#version 3.7;
sphere { 0, 1 pigment { marble wood } }
