// glass isosurfaces cut by their containers: rays that enter through the container's face find no surface just behind it
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.5, -1.5, -4> look_at 0 angle 45 }
light_source { <5, 8, -9>, 1 }
background { rgb <0.2, 0.25, 0.3> }
#macro Slice(Low, High, Colour)
    isosurface {
        function { sqrt(x*x + z*z*1.5 + pow(y - 0.3*cos(3*x), 2)) - 1 }
        accuracy 0.005
        max_gradient 2
        contained_by { box { <-1.5, Low, -1.5>, <1.5, High, 1.5> } }
        all_intersections
        pigment { rgbf Colour }
        finish { phong 1 reflection 0.2 }
        interior { ior 1.3 }
    }
#end
object { Slice(-1.2, -0.5, <1, 0.6, 0.6, 0.8>) }
object { Slice(-0.3, 0.2, <0.6, 1, 0.6, 0.8>) }
object { Slice(0.4, 1.2, <0.6, 0.7, 1, 0.8>) }
