// A round temple on an island, in low fog
// class: exact
// switches: +W640 +H480 +A0.2 +AM2 +R3 -J
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <6, 2.6, -15> look_at <0.4, 2.9, 0> angle 42 }
light_source { <-30, 22, -18>, rgb <1.3, 1.05, 0.75> }
light_source { <20, 30, -10>, rgb <0.12, 0.16, 0.25> shadowless }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.95, 0.72, 0.55>] [0.25 rgb <0.65, 0.62, 0.72>] [0.8 rgb <0.16, 0.25, 0.5>] } }
  pigment { wrinkles color_map { [0.35 rgbt 1] [0.7 rgbt <1, 0.85, 0.78, 0.35>] [1 rgbt <0.9, 0.8, 0.8, 0.1>] } turbulence 0.4 scale <0.7, 0.16, 0.7> }
}
fog { fog_type 2 distance 22 rgb <0.85, 0.75, 0.7> fog_offset 0 fog_alt 0.35 turbulence 0.2 turb_depth 0.3 }

#declare Stone = texture {
  pigment { granite color_map { [0 rgb <0.87, 0.82, 0.73>] [0.7 rgb <0.74, 0.67, 0.57>] [1 rgb <0.5, 0.44, 0.38>] } scale 1.4 }
  normal { granite 0.12 scale 0.5 }
}

// Water and island.
plane {
  y, 0
  pigment { rgb <0.04, 0.08, 0.1> }
  normal { bumps 0.12 scale <1.6, 1, 0.35> }
  finish { reflection { 0.1, 0.85 falloff 3 } specular 0.4 roughness 0.01 }
}
sphere { 0, 1 scale <7, 0.75, 5> texture { pigment { bozo color_map { [0 rgb <0.2, 0.3, 0.1>] [1 rgb <0.42, 0.38, 0.2>] } scale 0.5 } normal { bumps 0.8 scale 0.12 } } }

// Steps, columns, ring and dome.
#declare Columns = 12;
union {
  #for (I, 0, 3) cylinder { (0.55 + I*0.18)*y, (0.73 + I*0.18)*y, 3.7 - I*0.28 } #end
  #for (I, 0, Columns - 1)
    union {
      difference {
        cone { 1.3*y, 0.25, 3.9*y, 0.2 }
        #for (J, 0, 9) cylinder { y, 4*y, 0.045 translate 0.25*x rotate J*36*y } #end
      }
      torus { 0.26, 0.06 translate 1.33*y }
      box { <-0.3, 3.88, -0.3>, <0.3, 4.02, 0.3> }
      translate 2.3*x rotate I*360/Columns*y
    }
  #end
  difference { cylinder { 4.02*y, 4.5*y, 2.65 } cylinder { 4*y, 4.4*y, 1.95 } }
  torus { 2.65, 0.09 translate 4.48*y }
  difference { sphere { 0, 2.35 } sphere { 0, 2.2 } box { <-3, -3, -3>, <3, 0, 3> } cylinder { 0, 3*y, 0.4 } scale <1, 0.72, 1> translate 4.5*y }
  torus { 0.42, 0.07 translate 6.17*y }
  texture { Stone }
}
sphere { 0, 0.55 pigment { rgb <0.8, 0.55, 0.2> } finish { diffuse 0.3 specular 0.9 roughness 0.03 metallic reflection { 0.5 metallic } } translate 1.95*y }

// Cypresses.
#declare R = seed(31);
#for (I, 0, 8)
  #local P = <-5.8 + I*1.35 + rand(R)*0.5, 0.2, 2.6 + rand(R)*1.2>;
  #local H = 1.8 + rand(R)*1.6;
  cone {
    P, 0.34, P + H*y, 0.02
    pigment { bozo color_map { [0 rgb <0.04, 0.11, 0.05>] [1 rgb <0.12, 0.24, 0.08>] } scale <0.1, 0.4, 0.1> }
    normal { bumps 1.4 scale <0.08, 0.3, 0.08> }
  }
#end
