// open on a box
// error: 4:12 open
#version 3.7;
box { 0, 1 open }
