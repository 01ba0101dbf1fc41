// Names with underscores and digits
#version 3.7;
#declare _a = 1;
#declare a_1B = 2;
#declare A_Very_Long_Identifier_Name_Of_More_Than_Forty_Characters = 3;
#debug concat(str(_a, 0, 6), "\n") // expect: 1.000000
#debug concat(str(a_1B, 0, 6), "\n") // expect: 2.000000
#debug concat(str(A_Very_Long_Identifier_Name_Of_More_Than_Forty_Characters, 0, 6), "\n") // expect: 3.000000
