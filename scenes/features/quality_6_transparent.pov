// Quality 6: soft shadows and transparency, neither mirrors, bumps nor fog
// class: exact
// switches: +Q6
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 area_light <2, 0, 0>, <0, 0, 2>, 4, 4 }
light_source { <5, 8, -7>, rgb <0.3,0,0.3> }
background { rgb <0.35, 0.45, 0.6> }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.2,0.3,0.9>][1 rgb 1] } } }
plane { y, 0 texture { pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 quick_color rgb <0.7, 0.7, 0.5> } } texture { pigment { wood color_map { [0 rgbt <1,0,0,0.5>][1 rgbft <0,0.6,0,0.4,0.3>] } } } hollow }
sphere { <-0.8, 0.7, 0>, 0.7 texture { bozo texture_map { [0.3 pigment { rgb <0.9, 0.8, 0.3> } finish {emission 0.3} ] [0.7 pigment { rgb <0.6, 0.1, 0.1> } finish { reflection 0.3 phong 0.6 } ] } scale 0.2 } }
sphere { <0.7, 0.6, -0.4>, 0.5 pigment { rgbf <0.7, 0.9, 0.7, 0.8> } finish { ambient 0.2 specular 0.4 irid { 0.3 thickness 0.5} conserve_energy reflection { 0.1, 0.4 fresnel } } interior { ior 1.4 fade_distance 0.3 fade_power 2 fade_color rgb <1,0.5,0.3>} }
box { <0.6, 0, 0.6>, <1.6, 1.3, 1> pigment { rgb <0.2, 0.4, 0.8> }  }
box { <-0.6, 0, -1.6>, <-0.2, 0.3, -1.2> pigment { rgbt <0.9, 0.4, 0.3,0.6> quick_color rgbt <0,1,0,0.7> }  }
fog { distance 15 rgbt <0.8,0.8,0.9,0.2> }
