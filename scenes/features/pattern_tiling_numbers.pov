// The tilings by number, in squares side by side
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <3, 10, 2> direction -y up 4*z right 6*x }
#declare Number = 1;
#while (Number < 25)
    #declare Column = mod(Number - 1, 6);
    #declare Row = div(Number - 1, 6);
    box {
        <0.02, -1, 0.02>, <0.98, 0, 0.98>
        pigment {
            tiling Number
            color_map { [0 rgb <0.1, 0.1, 0.3>] [0.3 rgb <0.8, 0.4, 0.2>] [0.7 rgb <0.2, 0.7, 0.4>] [1 rgb <1, 0.9, 0.6>] }
            scale 0.13
            rotate 11*y
        }
        finish { ambient 0 diffuse 0 emission 1 }
        translate <Column, 0, Row>
    }
    #declare Number = Number + 1;
#end
