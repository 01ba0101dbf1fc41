// average without a map
// error: 4:25 average
#version 3.7;
sphere { 0, 1 pigment { average } }
