// boxes of cut and moved objects: planes across an axis cut them, a rotation takes the whole box along
#version 3.7;
#macro Extents(O) #local Thing = O #debug concat(vstr(3, min_extent(Thing), ",", 0, 3), " ", vstr(3, max_extent(Thing), ",", 0, 3), "\n") #end
Extents(difference { box { -1, 1 } plane { y, 0.25 } })
Extents(difference { box { -1, 1 } box { -2, 0.5 } })
Extents(intersection { torus { 1, 0.3 } plane { x, 0.5 inverse } })
Extents(intersection { sphere { 0, 1 } plane { x, 0.5 } rotate 30*y translate y })
Extents(union { sphere { 0, 1 } sphere { 3*x, 1 } rotate 45*y })
Extents(union { union { sphere { 0, 1 } sphere { 3*x, 1 } rotate 45*y } translate 2*x })
Extents(merge { box { 0, 1 } box { 2*x, 3 } rotate 30*y scale <1, 2, 1> })
// expect: -1.000,0.250,-1.000 1.000,1.000,1.000
// expect: -1.000,-1.000,-1.000 1.000,1.000,1.000
// expect: 0.500,-0.300,-1.300 1.300,0.300,1.300
// expect: -1.366,0.000,-1.116 0.933,2.000,1.366
// expect: -1.414,-1.000,-3.536 3.536,1.000,1.414
// expect: 0.586,-1.000,-3.536 5.536,1.000,1.414
// expect: 0.000,0.000,-1.500 4.098,6.000,2.598
