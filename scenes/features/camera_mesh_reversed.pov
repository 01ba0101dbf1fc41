// A mesh_camera that looks against the normals of a turned and stretched mesh
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Fan(W, H)
  mesh {
    #for (R, 0, H - 1) #for (C, 0, W - 1)
      #local D = <(C + 0.5)/W - 0.5, 0.5 - (R + 0.5)/H, 0>;
      #local N = vnormalize(<D.x, 0.75*D.y, 1>);
      #local A = vnormalize(vcross(y, N));
      #local B = vcross(N, A);
      #local P = <D.x/2, D.y/2, -4>;
      triangle { P + 0.02*B, P - 0.01*B + 0.02*A, P - 0.01*B - 0.02*A }
    #end #end
  }
#end
#declare Faces = Fan(image_width, image_height)
camera { mesh_camera { 1 0 mesh { Faces scale <1.5, 1, -1> rotate <10, -10, 0> } } location <0, 0, -2> direction -z }
light_source { <2, 4, -3>, rgb 1 }
background { rgb <0.2, 0.3, 0.5> }
plane { y, -1 pigment { checker rgb 0.9 rgb <0.3, 0.4, 0.5> } }
sphere { <0.8, 0, 1>, 1 pigment { rgb <0.9, 0.3, 0.2> } }
box { -0.6, 0.6 rotate 30*y translate <-1.2, -0.4, 1.6> pigment { rgb <0.2, 0.6, 0.4> } }
