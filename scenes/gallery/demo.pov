// A still life: glass, metal, wood and stone in evening light
// class: exact
// switches: +W640 +H480 +A0.2 +AM2 +R3 -J
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }

camera { location <0.6, 3.1, -7.6> look_at <0.25, 0.78, 0> angle 36 }

// A warm sun through a window, and the cool sky opposite.
light_source { <-9, 10, -7>, rgb <1.35, 1.15, 0.9> area_light <1.6, 0, 0>, <0, 1.6, 0>, 3, 3 adaptive 1 }
light_source { <9, 6, -5>, rgb <0.16, 0.22, 0.34> shadowless }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.95, 0.7, 0.5>] [0.35 rgb <0.4, 0.5, 0.75>] [1 rgb <0.1, 0.16, 0.4>] } }
  pigment { bozo color_map { [0.5 rgbt 1] [0.8 rgbt <1, 0.85, 0.75, 0.2>] } turbulence 0.6 scale <0.5, 0.12, 0.5> }
}

#declare Wood = texture {
  pigment {
    wood turbulence 0.06 octaves 4
    color_map { [0 rgb <0.42, 0.22, 0.1>] [0.5 rgb <0.55, 0.31, 0.15>] [0.85 rgb <0.3, 0.14, 0.06>] [1 rgb <0.42, 0.22, 0.1>] }
    scale 0.22 rotate <3, 88, 0>
  }
  normal { wood 0.12 turbulence 0.06 scale 0.22 rotate <3, 88, 0> }
  finish { specular 0.3 roughness 0.04 reflection { 0.02, 0.25 falloff 3 } }
}
#declare Brass = texture {
  pigment { rgb <0.78, 0.55, 0.22> }
  finish { ambient 0.05 diffuse 0.25 specular 0.9 roughness 0.02 metallic reflection { 0.55 metallic } brilliance 3 }
}
#declare Marble =
  texture { pigment { granite turbulence 0.3 color_map { [0 rgb <0.93, 0.9, 0.86>] [0.6 rgb <0.85, 0.83, 0.8>] [1 rgb <0.6, 0.62, 0.64>] } scale 1.5 } finish { diffuse 0.75 phong 0.3 } }
  texture { pigment { marble turbulence 0.9 color_map { [0 rgbt 1] [0.85 rgbt 1] [0.95 rgbt <0.25, 0.28, 0.32, 0.3>] [1 rgbt 1] } scale 0.7 rotate 40*z } finish { phong 0.4 } }
#declare Glass = material {
  texture { pigment { rgbf <0.96, 0.98, 1, 0.97> } finish { ambient 0 diffuse 0 specular 0.9 roughness 0.004 reflection { 1 fresnel } conserve_energy } }
  interior { ior 1.5 fade_distance 1.2 fade_power 2 fade_color <0.55, 0.85, 0.8> }
}

// The table.
#for (I, -5, 5)
  box { <-7, -0.2, -0.49>, <7, 0, 0.49> texture { Wood translate <I*3.3, I*0.37, I*0.21> } translate I*z }
#end

// A fluted marble column stump carries a glass ball.
#declare Flutes = 16;
difference {
  union {
    cylinder { 0, 0.9*y, 0.62 }
    box { <-0.78, 0, -0.78>, <0.78, 0.16, 0.78> }
    torus { 0.62, 0.08 translate 0.24*y }
    cylinder { 0.86*y, 1*y, 0.74 }
    torus { 0.66, 0.07 translate 0.84*y }
  }
  union {
    #for (I, 0, Flutes - 1)
      merge { cylinder { 0.42*y, 0.68*y, 0.075 } sphere { 0.42*y, 0.075 } sphere { 0.68*y, 0.075 } translate 0.64*x rotate I*360/Flutes*y }
    #end
  }
  texture { Marble }
  rotate 18*y translate <-1.25, 0, 0.5>
}
sphere { 0, 0.62 material { Glass } translate <-1.25, 1.62, 0.5> }

// A brass armillary sphere.
union {
  #for (I, 0, 2) torus { 0.78 - I*0.1, 0.028 rotate <90, I*60, I*25> } #end
  torus { 0.84, 0.035 rotate 90*x rotate 20*y }
  sphere { 0, 0.17 texture { pigment { agate agate_turb 0.7 color_map { [0 rgb <0.1, 0.2, 0.5>] [0.5 rgb <0.15, 0.45, 0.3>] [1 rgb <0.9, 0.9, 0.85>] } scale 0.2 } finish { phong 0.6 } } }
  cylinder { -1.02*y, 1.02*y, 0.016 rotate 23.5*z }
  sphere { 1.02*y, 0.05 rotate 23.5*z }
  texture { Brass }
  translate <0.95, 1.42, 0.45>
}
union {
  cone { 0, 0.42, 0.12*y, 0.16 }
  cylinder { 0, 0.6*y, 0.05 }
  torus { 0.4, 0.045 translate 0.045*y }
  sphere { 0.34*y, 0.11 }
  texture { Brass }
  translate <0.95, 0, 0.45>
}

// Dice, one solid, one of ruby glass.
#macro Pip(X, Y, Z) sphere { <X, Y, Z>*0.29, 0.055 } #end
#macro Die()
  difference {
    intersection { box { -0.27, 0.27 } sphere { 0, 0.4 } }
    union {
      Pip(0, 1, 0)
      Pip(0.4, 0.4, -1) Pip(-0.4, -0.4, -1) Pip(0, 0, -1)
      Pip(1, 0.4, 0.4) Pip(1, -0.4, -0.4)
      Pip(-1, 0.4, 0.4) Pip(-1, -0.4, -0.4) Pip(-1, 0.4, -0.4) Pip(-1, -0.4, 0.4)
      pigment { rgb 0.95 }
    }
  }
#end
object { Die() pigment { rgb <0.08, 0.2, 0.16> } finish { phong 0.7 phong_size 60 reflection 0.08 } rotate 25*y translate <-0.05, 0.27, -1.5> }
object {
  Die() pigment { rgbf <0.95, 0.25, 0.25, 0.85> } finish { specular 0.8 roughness 0.01 reflection { 0.02, 0.6 falloff 3 } } interior { ior 1.4 }
  rotate <90, 0, 0> rotate -15*y translate <0.75, 0.27, -1.85>
}

// Pearls along an arc.
#declare R = seed(7);
#for (I, 0, 13)
  #local A = radians(200 + I*8.5);
  #local Size = 0.085 + 0.02*rand(R);
  sphere {
    <-0.9 + 1.15*cos(A), Size, -0.75 + 1.0*sin(A)>, Size
    pigment { rgb <0.95, 0.9 - 0.1*rand(R), 0.85 - 0.15*rand(R)> }
    normal { bumps 0.05 scale 0.03 }
    finish { diffuse 0.7 specular 0.6 roughness 0.02 reflection { 0.05, 0.5 falloff 2 } }
  }
#end
