// #case without #switch
// error: 4:1 #case
#version 3.7;
#case (1)
