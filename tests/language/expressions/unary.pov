// Signs may be stacked; ! binds tighter than *
#version 3.7;
#debug concat(str(--3, 0, 6), "\n") // expect: 3.000000
#debug concat(str(-+-4, 0, 6), "\n") // expect: 4.000000
#debug concat(str(!0*5, 0, 6), "\n") // expect: 5.000000
#debug concat(str(!3, 0, 6), "\n") // expect: 0.000000
#debug concat(str(-!0, 0, 6), "\n") // expect: -1.000000
#debug concat(str(2*-3, 0, 6), "\n") // expect: -6.000000
#debug concat(str(5--2, 0, 6), "\n") // expect: 7.000000
