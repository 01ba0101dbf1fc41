// endless shapes made finite by bounded_by: intersections of planes, whose boxes are those of their bounds
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -7> look_at <0, 0.7, 0> angle 50 }
light_source { <-5, 9, -8>, 1 }
#macro Pyramids(Depth)
    #if (Depth)
        #local Part = Pyramids(Depth - 1)
        union {
            object { Part scale 0.5 translate 1.5*y }
            #for (I, 0, 2)
                object { Part scale 0.5 translate <0, -0.5, sqrt(2)> rotate 120*I*y }
            #end
        }
    #else
        intersection {
            plane { -y, 1 }
            #for (I, 0, 2)
                plane { -y, 1 rotate 109.5*x rotate 120*I*y }
            #end
            bounded_by { sphere { 0, 4 } }
        }
    #end
#end
object { Pyramids(3) rotate 30*y pigment { rgb <0.9, 0.8, 0.2> } }
plane { y, 0 bounded_by { box { <-3, -1, 2>, <3, 3, 3> } } translate -0.9*y pigment { rgb 0.6 } }
