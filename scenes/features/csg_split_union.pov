// Unions that are kept whole and unions that are split look the same
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -5> look_at <0, 0.5, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb 0.8 rgb 0.4 } }
#declare Parts = union { sphere { <0, 0.5, 0>, 0.5 } box { <0, 0, -0.4>, <0.8, 0.7, 0.4> } }
union { Parts split_union on translate <-1.3, 0, 0> pigment { rgbt <0.8, 0.3, 0.2, 0.4> } }
union { Parts split_union off translate <0.5, 0, 0> pigment { rgbt <0.2, 0.5, 0.8, 0.4> } }
