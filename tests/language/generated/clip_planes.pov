// Clip planes in an array, macros with #if inside objects, calls without a comma, defaults set again between objects
#if (version < 3.5)
#error "VMD POV3DisplayDevice has been compiled for POV-Ray 3.5 or above.\nPlease upgrade POV-Ray."
#end
#version 3.5;
#declare VMD_clip_on = array[3] { 0, 1, 0 };
#declare VMD_clip = array[3];
#declare VMD_scaledclip = array[3];
#declare VMD_line_width = 0.0020;
#declare VMD_clip[1] = plane { <0,0,1>, 0.5 }
#macro VMDC ( C1 )
  texture { pigment { rgbt C1 } }
#end
#macro VMD_point (P1, R1, C1)
  #local T = texture { finish { ambient 1.0 diffuse 0.0 phong 0.0 specular 0.0 } pigment { C1 } }
  #if (VMD_clip_on[2])
  intersection { sphere { P1, R1 texture { T } #if (VMD_clip_on[1]) clipped_by { VMD_clip[1] } #end no_shadow } VMD_clip[2] }
  #else
  sphere { P1, R1 texture { T } #if (VMD_clip_on[1]) clipped_by { VMD_clip[1] } #end no_shadow }
  #end
#end
#macro VMD_sphere (P1, R1, C1)
  sphere { P1, R1 texture { pigment { C1 } } #if (VMD_clip_on[1]) clipped_by { VMD_clip[1] } #end no_shadow }
#end
#macro VMD_cylinder (P1, P2, R1, C1, O1)
  cylinder { P1, P2, R1 #if (O1) open #end texture { pigment { C1 } } #if (VMD_clip_on[1]) clipped_by { VMD_clip[1] } #end no_shadow }
#end
camera { up <0, 3.0000, 0> right <4.0000, 0, 0> location <0.0, 0.0, -2.0> look_at <0.0, 0.0, 2.0> direction <0.0, 0.0, 4.0> }
light_source { <-0.1000, 0.1000, -1.0000> color rgb<1.000, 1.000, 1.000> parallel point_at <0.0, 0.0, 0.0> }
background { color rgb<0.000, 0.000, 0.000> }
#default { texture { finish { ambient 0.000 diffuse 0.650 phong 0.1 phong_size 40.000 specular 0.500 } } }
VMD_sphere(<-0.1,0.2,0.3>,0.0361,rgbt<0.25,0.75,0.75,0>)
VMD_cylinder(<-0.6,0.2,0.3>,<0.6,0.2,0.3>0.0361,rgbt<0.250,0.750,0.750,0.000>,1)
#default { texture { finish { ambient 0.1 } } }
VMD_point(<0,0,0>, 0.01, rgb <1,0,0>)
#declare VMDC2 = union { VMD_sphere(<0,0,0>, 1, rgb 1) VMD_sphere(<2,0,0>, 1, rgb 1) }
#declare Ball = sphere { <1,2,3>, 1 }
#debug concat(vstr(3, max_extent(Ball), ",", 0, 2), "\n") // expect: 2.00,3.00,4.00
#debug concat(str(dimension_size(VMD_clip_on, 1), 0, 0), "\n") // expect: 3
