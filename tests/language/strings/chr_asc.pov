// chr and asc
#version 3.7;
#debug concat(chr(65), "\n") // expect: A
#debug concat(str(asc("A"), 0, 6), "\n") // expect: 65.000000
#debug concat(str(asc("zebra"), 0, 6), "\n") // expect: 122.000000
#debug concat(concat(chr(72),chr(105)), "\n") // expect: Hi
