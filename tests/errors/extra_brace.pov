// A closing brace too many
// error: 4:17 }
#version 3.7;
sphere { 0, 1 } }
