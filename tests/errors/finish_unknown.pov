// An item that a finish does not have
// error: 4:24 'frequency'
#version 3.7;
sphere { 0, 1 finish { frequency 2 } }
