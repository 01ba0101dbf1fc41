// strupr and strlwr
#version 3.7;
#debug concat(strupr("Abc xyz 1"), "\n") // expect: ABC XYZ 1
#debug concat(strlwr("Abc XYZ 1"), "\n") // expect: abc xyz 1
