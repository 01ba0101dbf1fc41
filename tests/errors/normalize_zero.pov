// vnormalize of the zero vector only warns
// warning: 4:14 vnormalize
#version 3.7;
#declare V = vnormalize(<0, 0, 0>);
