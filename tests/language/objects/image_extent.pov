// max_extent of an image pigment is its size
#version 3.7;
#declare P = pigment { image_map { png "small.png" } }
#debug concat(vstr(3, max_extent(P), ",", 0, 6), "\n") // expect: 5.000000,3.000000,0.000000
