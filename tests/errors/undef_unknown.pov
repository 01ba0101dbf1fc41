// #undef of an unknown name only warns
// warning: 4:8 'Nothing'
#version 3.7;
#undef Nothing
