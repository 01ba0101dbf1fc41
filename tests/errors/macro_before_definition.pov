// A macro called before it is defined
// error: 4:14 'Later'
#version 3.7;
#declare A = Later();
#macro Later() 1 #end
