// global_settings inside an object
// error: 4:15 'global_settings'
#version 3.7;
sphere { 0, 1 global_settings { max_trace_level 3 } }
