// Sums in the blocks of a macro are worked out where they stand
#version 3.7;
#macro Width(Size) #local Thing = box { 0, Size*x + <1, 2, 3> translate Size*y } (max_extent(Thing).x - min_extent(Thing).x) #end
#debug concat(str(2*Width(3), 0, 3), "\n")
#declare A = (#local Ball = sphere { 0, 1 + 1 } max_extent(Ball).y + 1);
#debug concat(str(A, 0, 3), "\n")
#macro Wide(S) #local Thing = text { internal 1 "Wide" 1 S*x } max_extent(Thing).z #end
#debug concat(str(Wide(0.1), 0, 3), "\n")
// expect: 8.000
// expect: 3.000
// expect: 1.000
