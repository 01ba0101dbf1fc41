// Relations give 1 or 0 and associate to the left
#version 3.7;
#debug concat(str((1<2), 0, 6), "\n") // expect: 1.000000
#debug concat(str((1<2<3), 0, 6), "\n") // expect: 1.000000
#debug concat(str((3>2>1), 0, 6), "\n") // expect: 0.000000
#debug concat(str((2>=2), 0, 6), "\n") // expect: 1.000000
#debug concat(str((2!=2), 0, 6), "\n") // expect: 0.000000
#debug concat(str((2<=1), 0, 6), "\n") // expect: 0.000000
#debug concat(str((1=1), 0, 6), "\n") // expect: 1.000000
