// Blanks between # and the word
#version 3.7;
# declare A = 2;
#	declare B = 3;
#debug concat(str(A+B, 0, 6), "\n") // expect: 5.000000
