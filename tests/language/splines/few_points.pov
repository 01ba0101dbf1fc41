// splines through fewer points than their kind needs
#version 3.7;
#macro Print(S) #for (I, -1, 3) #debug concat(str(S(I).x, 0, 3), " ") #end #debug "\n" #end
#declare S = spline { cubic_spline 0, 0 1, 3 } Print(S)
#declare S = spline { cubic_spline 0, 0 1, 3 2, 7 } Print(S)
#declare S = spline { cubic_spline 1, 3 } Print(S)
#declare S = spline { quadratic_spline 0, 0 1, 3 } Print(S)
#declare S = spline { natural_spline 0, 0 1, 3 } Print(S)
// expect: 1.500 1.500 1.500 1.500 1.500
// expect: 3.000 3.000 3.000 3.000 3.000
// expect: 3.000 3.000 3.000 3.000 3.000
// expect: 0.000 0.000 3.000 3.000 3.000
// expect: 0.000 0.000 3.000 3.000 3.000
