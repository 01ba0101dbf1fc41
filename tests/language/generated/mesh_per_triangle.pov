// One mesh2 per triangle with three textures, glued numbers, direction and negative right
#version 3.5;
global_settings { assumed_gamma 1 }
camera {direction<0.0,0.0,  -2.836>
 location <0.0 , 0.0 , 0.0>
 right 1.322*x up y
 }
#default { texture { finish{phong 0.500 phong_size   59.000}}}
light_source{<4000.0001,4000.0001,9999.9999>  rgb<1.0,1.0,1.0>}
plane{z , -60.0000
 pigment{color rgb<0.0000,0.0000,0.0000>}
 finish{phong 0 specular 0 diffuse 0 ambient 1.0}}
mesh2 { vertex_vectors { 3, <0.1,0.2,-30>, <1.1,0.2,-30>, <0.1,1.2,-30> }
 normal_vectors { 3,
<0.,0.,1.>,
<0.,0.,1.>,
<0.,0.,1.>}
texture_list { 3,
texture { pigment{color rgbt<1.0000,0.0000,0.0000,0.25>}}
texture { pigment{color rgbt<0.0000,1.0000,0.0000,0.25>}}
texture { pigment{color rgbt<0.0000,0.0000,1.0000,0.25>}} }
face_indices { 1, <0,1,2>, 0, 1, 2 } }
cylinder{<0.1,0.2,-30.0>,
<1.0000,0.2000,-29.0000>,
 0.2500
open
pigment{color rgb<0.2,1.0,0.2>}}
sphere{<0.1,0.2,-31.0>,  1.70001 pigment{color rgb<0.2,1.0,0.2>}}
#declare M = mesh2 { vertex_vectors { 3, 0, x, y, } face_indices { 1, <0,1,2>, } }
#debug concat(vstr(3, max_extent(M), ",", 0, 1), "\n") // expect: 1.0,1.0,0.0
