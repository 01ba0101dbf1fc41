// A sphere flake of 7381 mirrors, built by a recursive macro
// class: exact
// switches: +W640 +H480
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
#declare Levels = 4;

camera { location <2.2, 2.4, -5.4> look_at <0, 0.1, 0> angle 36 }
light_source { <-6, 9, -7>, rgb <1.1, 1, 0.9> }
light_source { <8, 4, -4>, rgb <0.2, 0.25, 0.4> }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.75, 0.75, 0.8>] [1 rgb <0.12, 0.2, 0.45>] } } }
plane { y, -1.05 pigment { checker rgb <0.8, 0.78, 0.72> rgb <0.25, 0.32, 0.38> } finish { reflection 0.15 } }

// Nine children around each ball: six at the equator, three above.
#macro Flake(Level, Centre, Radius, Up)
  sphere { Centre, Radius }
  #if (Level > 0)
    #local Side = vnormalize(vcross(Up, <Up.y + 0.3, -Up.z, Up.x + 0.1>));
    #for (I, 0, 8)
      #local Tilt = (I < 6 ? 90 : 35);
      #local Way = vaxis_rotate(vaxis_rotate(Up, Side, Tilt), Up, I*(I < 6 ? 60 : 120) + (I < 6 ? 0 : 30));
      Flake(Level - 1, Centre + Way*Radius*4/3, Radius/3, Way)
    #end
  #end
#end
union {
  Flake(Levels, 0, 0.7, y)
  pigment { rgb <0.6, 0.55, 0.5> }
  finish { diffuse 0.4 specular 0.7 roughness 0.01 reflection { rgb <0.5, 0.5, 0.55> } }
  rotate <12, 20, 0>
}
