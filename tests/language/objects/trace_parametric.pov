// Where rays meet parametric surfaces, with and without boxes worked out before
#version 3.7;
#macro Try(O, P, D) #declare N = <0, 0, 0>; #debug concat(vstr(3, trace(O, P, D, N), ",", 0, 7), " ", vstr(3, N, ",", 0, 4), "\n") #end
#macro All(O) Try(O, <0.3, 0.2, -2>, z) Try(O, <-2, -1, -1.5>, <2, 1.1, 1.7>) Try(O, <2, 1, 2>, <-2.2, -1.3, -1.9>) #end
#declare Saddle = parametric { function { u } function { v } function { u*v } <-1, -1>, <1, 1> contained_by { sphere { 0, 1.2 } } max_gradient 1 accuracy 0.01 }
#declare Ring = parametric {
  function { cos(u)*(0.7 + 0.3*cos(v)) } function { 0.3*sin(v) } function { sin(u)*(0.7 + 0.3*cos(v)) }
  <0, 0>, <2*pi, 2*pi> contained_by { box { <-1.1, -0.4, -1.1>, <1.1, 0.4, 1.1> } } accuracy 0.02 precompute 10, x, y, z
}
All(Saddle) All(Ring) All(object { Saddle rotate 30*x scale 0.7 })

// expect: 0.3000000,0.2000000,0.0460760 -0.1907,-0.2861,0.9390
// expect: -0.2505953,-0.0378274,-0.0130060 0.0227,0.2425,0.9699
// expect: -0.2288689,-0.3170589,0.0750677 0.3038,0.2243,0.9260
// expect: 0.3000000,0.2000000,-0.8927972 -0.2484,-0.6967,0.6730
// expect: -0.7415879,-0.3078733,-0.4303497 0.3414,0.9200,0.1924
// expect: 0.5606268,0.1494613,0.7569050 -0.5094,-0.5226,-0.6836
// expect: 0.3000000,0.2000000,0.2530338 -0.3672,-0.7453,0.5565
// expect: -0.2619127,-0.0440520,-0.0226258 0.0586,-0.1706,0.9836
// expect: -0.3334627,-0.3788643,-0.0152632 0.4125,-0.0489,0.9097
