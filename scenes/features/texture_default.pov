// The default texture changed by #default
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
#default { pigment { checker rgb <0.9, 0.8, 0.3> rgb <0.5, 0.15, 0.3> scale 0.3 } finish { ambient 0.3 diffuse 0.5 phong 0.6 } }
camera { location <1.3, 1.9, -5.2> look_at <0.15, 0, 0> angle 42 }
light_source { <-4, 7, -8>, rgb 1 }
background { rgb <0.25, 0.32, 0.45> }
box { <-1.6, -1, -0.5>, <-0.2, 1, 0.7> rotate 20*y }
sphere { <1.1, 0, 0>, 0.9 pigment { rgb <0.3, 0.6, 0.8> } }
#default { finish { phong 0 reflection 0.3 } }
sphere { <0.3, -0.9, -1>, 0.4 }
