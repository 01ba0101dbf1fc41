// Quality 3
// class: exact
// switches: +Q3
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 area_light <2, 0, 0>, <0, 0, 2>, 4, 4 }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 quick_color rgb <0.7, 0.7, 0.5> } }
sphere { <-0.8, 0.7, 0>, 0.7 pigment { granite color_map { [0 rgb <0.9, 0.8, 0.3>] [1 rgb <0.6, 0.1, 0.1>] } } finish { reflection 0.3 phong 0.6 } }
sphere { <0.7, 0.6, -0.4>, 0.5 pigment { rgbf <0.7, 0.9, 0.7, 0.8> } finish { ambient 0.2 } interior { ior 1.4 } }
box { <0.6, 0, 0.6>, <1.6, 1.3, 1> pigment { rgb <0.2, 0.4, 0.8> } normal { bumps 0.6 scale 0.1 } }
