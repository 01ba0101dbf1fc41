// A sor whose heights do not increase
// error: 4:36 sor
#version 3.7;
sor { 4, <0, 0>, <1, 1>, <1, 0.5>, <0, 2> }
