// rand in a vector runs left to right
#version 3.7;
#declare R = seed(2);
#declare V = <rand(R), rand(R), rand(R)>;
#debug concat(vstr(3, V, ",", 0, 6), "\n") // expect: 0.843983,0.507679,0.082722
