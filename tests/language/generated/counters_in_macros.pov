// Short macros called for every atom; #declare of globals inside them counts
#version 3.5;
global_settings { ambient_light rgb <0.45,0.45,0.45> }
#declare _CLIP1 = plane { z, 1 }
camera { perspective angle 30 right <-1, 0, 0>*image_width/image_height up <0,-1,0> sky <0,-1,0> location <0,0,-10> look_at 0 }
#declare N = 0;
#macro a(X,Y,Z,RADIUS,R,G,B,T)
 #declare N = N + 1;
 sphere{<X,Y,Z>,RADIUS
  pigment{rgbt<R,G,B,T>} finish { ambient 0.1 }}
#end
#macro q(XX,YY,ZZ,XY,XZ,YZ,X,Y,Z,J,R,G,B,T)
 quadric{<XX,YY,ZZ>,<XY,XZ,YZ>,<X,Y,Z>,J
  pigment{rgbt<R,G,B,T>} clipped_by { sphere { 0, 2 } }}
#end
#macro b(X1,Y1,Z1,RADIUS1,X2,Y2,Z2,RADIUS2,R,G,B,T)
 cone{<X1,Y1,Z1>,RADIUS1,<X2,Y2,Z2>,RADIUS2
  pigment{rgbt<R,G,B,T>}}
#end
#macro p(X1,Y1,Z1,X2,Y2,Z2,X3,Y3,Z3,R,G,B,T)
 #local K = N + 1; #declare N = K;
 polygon{4,<X1,Y1,Z1>,<X2,Y2,Z2>,<X3,Y3,Z3>,<X1,Y1,Z1> pigment{rgbt<R,G,B,T>}}
#end
a(1,2,3,0.5,1,0,0,0)
a(1.5,-2,3,0.5,1,0,0,0)
b(0,0,0,0.2,1,1,1,0.2,0,1,0,0)
q(1,1,1,0,0,0,0,0,0,-1,1,1,1,0)
p(0,0,0,1,0,0,0,1,0,1,1,1,0)
#debug concat(str(N, 0, 0), "\n") // expect: 3
