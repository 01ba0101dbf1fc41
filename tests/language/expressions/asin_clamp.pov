// asin and acos clamp their argument
#version 3.7;
#debug concat(str(asin(1.5), 0, 6), "\n") // expect: 1.570796
#debug concat(str(acos(-2), 0, 6), "\n") // expect: 3.141593
