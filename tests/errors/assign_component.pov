// Setting one component
// error: 5:10
#version 3.7;
#declare V = <1, 2, 3>;
#declare V.x = 5;
