// A union of nothing only warns
// warning: 4:9 union
#version 3.7;
union { }
