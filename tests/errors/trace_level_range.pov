// A max_trace_level out of range only warns
// warning: 4:35 max_trace_level
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1000 }
