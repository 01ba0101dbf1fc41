// The gamma of an image: as stored, given, and linear
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.5, 1.6, -6> look_at <2.1, 1, 0> angle 45 }
background { rgb 0.3 }
#declare Places = array[6] { <0, 1.1>, <1.5, 1.1>, <3, 1.1>, <0, 0>, <1.5, 0>, <3, 0> }
#macro Panel(P, I) box { <0, 0, 0>, <1.3, 1, 0.1> pigment { P scale <1.3, 1, 1> } finish { ambient 1 diffuse 0 } translate Places[I] } #end
Panel(pigment { image_map { png "images/flag.png" gamma 1 } }, 0)
Panel(pigment { image_map { png "images/flag.png" gamma srgb } }, 1)
Panel(pigment { image_map { png "images/flag_gamma.png" } }, 2)
Panel(pigment { image_map { png "images/flag.png" gamma 1.8 } }, 3)
Panel(pigment { image_map { hdr "images/flag.hdr" } }, 4)
Panel(pigment { image_map { exr "images/flag.exr" } }, 5)
