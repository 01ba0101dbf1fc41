// A word of a later version than the scene's
// error: 4:48 'blend_mode' is not declared
// hint: 'blend_mode' is a word of version 3.8
sphere { 0, 1 pigment { gradient x color_map { blend_mode 2 [0 rgb 0] [1 rgb 1] } } }
