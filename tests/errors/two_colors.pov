// Two colours in one pigment
// error: 4:31
#version 3.7;
sphere { 0, 1 pigment { rgb x rgb z } }
