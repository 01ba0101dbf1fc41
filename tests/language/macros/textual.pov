// A body is spliced in: 2*S(1,2) is 4
#version 3.7;
#macro S(a,b) a+b #end
#debug concat(str(2*S(1,2), 0, 6), "\n") // expect: 4.000000
#macro P(a,b) (a+b) #end
#debug concat(str(2*P(1,2), 0, 6), "\n") // expect: 6.000000
#macro M() 1+2 #end
#debug concat(str(2*M(), 0, 6), "\n") // expect: 4.000000
#debug concat(str(M()*2, 0, 6), "\n") // expect: 5.000000
