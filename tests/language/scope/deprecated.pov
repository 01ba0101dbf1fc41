// A deprecated identifier still works
#version 3.7;
#declare deprecated once "use New" Old = 3;
#debug concat(str(Old, 0, 6), "\n") // expect: 3.000000
#debug concat(str(Old+1, 0, 6), "\n") // expect: 4.000000
