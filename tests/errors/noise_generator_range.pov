// A noise generator that does not exist
// error: 4:35 noise_generator
#version 3.7;
global_settings { noise_generator 5 }
