// Components of calls and identifiers
#version 3.7;
#declare F = function(a,b) { a*b }
#debug concat(str(F(2,3)*2, 0, 6), "\n") // expect: 12.000000
#debug concat(str(vcross(x,y).z, 0, 6), "\n") // expect: 1.000000
#debug concat(str(vrotate(<1,2,3>,90*y).x, 0, 6), "\n") // expect: 3.000000
