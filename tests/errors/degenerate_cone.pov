// A cone of no length
// error: 4:8 cone
#version 3.7;
cone { y, 1, y, 0.5 }
