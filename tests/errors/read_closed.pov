// #read from a handle that is not open
// error: 4:1 'In'
#version 3.7;
#read (In, A)
