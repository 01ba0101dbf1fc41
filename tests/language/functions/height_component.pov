// In a function, a pigment function has the components gray, grey and hf: the height that red and green make
#version 3.7;
#declare F = function { pigment { gradient x color_map { [0 rgbft <0.1, 0.2, 0.3, 0.4, 0.05>] [1 rgbft <0.9, 0.7, 0.5, 0.3, 0.1>] } } }
#declare G = function { F(x, y, z).hf + 1 }
#debug concat(str(G(0, 0, 0), 0, 6), " ", str(G(0.6, 0, 0), 0, 6), "\n") // expect: 1.100391 1.579687
#declare H = function { F(x, y, z).gray - F(x, y, z).grey }
#debug concat(str(H(0.6, 0, 0), 0, 6), "\n") // expect: 0.000000
