// defined() of names of all kinds
#version 3.7;
#declare N = 1; #declare S = "s"; #declare O = sphere{0,1} #macro M() #end
#debug concat(str(defined(N), 0, 6), "\n") // expect: 1.000000
#debug concat(str(defined(S), 0, 6), "\n") // expect: 1.000000
#debug concat(str(defined(O), 0, 6), "\n") // expect: 1.000000
#debug concat(str(defined(M), 0, 6), "\n") // expect: 1.000000
#debug concat(str(defined(Nope), 0, 6), "\n") // expect: 0.000000
