// with charset utf8 a character beyond ASCII counts as one
#version 3.7;
global_settings { charset utf8 }
#declare S = "aéö€b";
#declare I = 1;
#while (I <= strlen(S)) #debug concat(str(asc(substr(S, I, 1)), 0, 0), " ") #declare I = I + 1; #end
#debug "\n"
// expect: 97 233 246 8364 98
