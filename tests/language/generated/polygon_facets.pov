// One polygon per facet, two global_settings, right twice, a file included at the end
#version 3.7;
global_settings { assumed_gamma 1.0 }
#default { finish { ambient 0.2 } }
#declare MaterialOfCAD = texture { pigment { color rgb <0.98, 0.84, 0.17> } }
union {
polygon { 5, <0, 0, 0>, <1, 0, 0>, <1, 1, 0>, <0, 1, 0>, <0, 0, 0>
 texture { MaterialOfCAD } }
polygon { 4, <0,0,0>, <1,0,0>, <0,0,1>, <0,0,0> texture { MaterialOfCAD } }
rotate <0, clock * 360, 0>
}
#declare CamUp = <0, 0, 1>;
camera { location <10,-10,5> right -x*image_width/image_height up z sky CamUp right -x*1.5 look_at 0 angle 20 }
global_settings { max_trace_level 10 photons { count 20000 } }
#include "rad_def.inc"
global_settings { radiosity { Rad_Settings(Radiosity_Fast, off, off) } }
#debug concat(str(clock, 0, 0), "\n")
// expect:
// expect: Radiosity_Fast in use
// expect: 0
