// sturm on a sphere
// error: 4:15 sturm
#version 3.7;
sphere { 0, 1 sturm }
