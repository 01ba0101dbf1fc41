// A second assumed_gamma only warns
// warning: 5:19 assumed_gamma
#version 3.7;
global_settings { assumed_gamma 1 }
global_settings { assumed_gamma 2.2 }
