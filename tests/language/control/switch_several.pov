// Several labels for one branch
#version 3.7;
#macro Kind(N) #switch (N) #case (1) #case (3) #case (5) "odd" #break #range (10,20) "teen" #break #else "other" #end #end
#debug concat(Kind(3), "\n") // expect: odd
#debug concat(Kind(15), "\n") // expect: teen
#debug concat(Kind(4), "\n") // expect: other
