// strlen and strcmp
#version 3.7;
#debug concat(str(strlen(""), 0, 6), "\n") // expect: 0.000000
#debug concat(str(strlen("hello"), 0, 6), "\n") // expect: 5.000000
#debug concat(str(strcmp("a","b"), 0, 6), "\n") // expect: -1.000000
#debug concat(str(strcmp("b","a"), 0, 6), "\n") // expect: 1.000000
#debug concat(str(strcmp("a","a"), 0, 6), "\n") // expect: 0.000000
#debug concat(str(strcmp("abc","ab"), 0, 6), "\n") // expect: 99.000000
#debug concat(str(strcmp("A","a"), 0, 6), "\n") // expect: -32.000000
