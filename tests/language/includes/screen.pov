// Objects fixed to the screen: camera macros keep their values
#version 3.7;
global_settings { assumed_gamma 1 }
#include "screen.inc"
Set_Camera(<3, 2, -8>, <0, 1, 0>, 40)
Set_Camera_Aspect(16, 9)
#declare Ball = sphere { 0, 0.1 }
#declare Fixed = object { Screen_Object(Ball, <0.5, 0.5>, <0.02, 0.02>, true, 0.01) }
#debug concat(vstr(3, min_extent(Fixed), ",", 0, 4), "\n")
#debug concat(vstr(3, max_extent(Fixed), ",", 0, 4), "\n")
Set_Camera_Zoom(2)
Set_Camera_Sky(y)
Screen_Plane(texture { pigment { rgb 1 } }, 0.01, <0, 0>, <0.2, 0.2>)
Reset_Camera()
#debug concat(str(Camera_Aspect_Ratio, 0, 4), "\n")
// expect: 2.9939,1.9973,-7.9886
// expect: 2.9965,1.9995,-7.9858
// expect: 1.0000
