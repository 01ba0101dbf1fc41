// An isosurface without a function
// error: 4:14 function
#version 3.7;
isosurface { contained_by { sphere { 0, 1 } } }
