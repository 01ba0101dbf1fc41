// A wavy surface of 125,000 triangles with smooth normals
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -5> look_at <0, -0.2, 0> angle 45 }
light_source { <5, 8, -6>, rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
#declare N = 250;
#declare Height = function(x, y, z) { 0.35*sin(3*x)*cos(2*z) + 0.05*sin(23*x + 11*z) }
mesh2 {
  vertex_vectors { (N+1)*(N+1)
    #for (I, 0, N) #for (J, 0, N) #local X = 4*I/N - 2; #local Z = 4*J/N - 2; , <X, Height(X, 0, Z), Z> #end #end }
  normal_vectors { (N+1)*(N+1)
    #for (I, 0, N) #for (J, 0, N)
      #local X = 4*I/N - 2; #local Z = 4*J/N - 2; #local E = 0.001;
      , <Height(X - E, 0, Z) - Height(X + E, 0, Z), 2*E, Height(X, 0, Z - E) - Height(X, 0, Z + E)>
    #end #end }
  face_indices { 2*N*N
    #for (I, 0, N-1) #for (J, 0, N-1) #local A = I*(N+1) + J; , <A, A+1, A+N+2>, <A, A+N+2, A+N+1> #end #end }
  pigment { rgb <0.8, 0.5, 0.3> } finish { phong 0.5 }
}
