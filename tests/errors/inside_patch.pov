// inside() of an object without one
// error: 5:14
#version 3.7;
#declare T = triangle { 0, x, y }
#declare A = inside(T, 0);
