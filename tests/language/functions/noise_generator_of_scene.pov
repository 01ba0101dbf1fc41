// The scene's noise_generator holds for functions of noise
#version 3.7;
global_settings { assumed_gamma 1 noise_generator 1 }
#declare F = function { internal(76) }
#debug concat(str(F(0.1,0.2,0.3), 0, 6), "\n") // expect: 0.299243
#declare G = function { pattern { bozo } }
#debug concat(str(G(0.1,0.2,0.3), 0, 6), "\n") // expect: 0.299243
