// Words of two and four bytes, clamped and rounded
#version 3.7;
#fopen Out "words.txt" write
#write (Out, uint8 34, uint16be 16706, uint16le 16706, sint16be 16706, sint16le 16706, sint32be 1094861636, sint32le 1094861636, uint8 65.4 65.6 34)
#fclose Out
#fopen In "words.txt" read
#read (In, S)
#fclose In
#debug concat(S, "\n") // expect: ABBAABBAABCDDCBAAB
