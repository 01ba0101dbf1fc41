// parametric surfaces steeper than max_gradient says, with and without precomputed boxes
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> look_at 0 angle 45 }
light_source { <-3, 6, -9>, 1 }
#macro Waves(Slow)
    parametric {
        function { u*2 - 1 }
        function { 0.1*(sin(u*12) + sin(v*12)) }
        function { v*2 - 1 }
        <0, 0>, <1, 1>
        contained_by { box { -1.1, 1.1 } }
        max_gradient 0.5
        accuracy 0.01
        #if (!Slow) precompute 10, x, y, z #end
        pigment { rgb <0.6, 0.8, 1> }
    }
#end
object { Waves(0) translate -1.4*x }
object { Waves(1) translate 1.4*x }
