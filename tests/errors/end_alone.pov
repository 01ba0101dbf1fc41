// #end without a beginning
// error: 5:1 #end
#version 3.7;
sphere { 0, 1 }
#end
