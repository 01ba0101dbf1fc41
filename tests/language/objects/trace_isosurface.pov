// Where rays meet isosurfaces: from outside, from inside, through the container, open, scaled
#version 3.7;
#macro Try(O, X) #debug concat(" ", str(trace(O, X*x, x).x, 0, 9)) #end
#macro All(O) Try(O, -2) Try(O, -0.5) Try(O, 0) Try(O, 0.28) Try(O, 0.35) #debug "\n" #end
#declare Right = isosurface { function { 0.3 - x } contained_by { box { -1, 1 } } max_gradient 1.5 accuracy 0.01 }
#declare Left = isosurface { function { x - 0.3 } contained_by { box { -1, 1 } } max_gradient 1.5 accuracy 0.01 }
#declare Open = isosurface { function { x - 0.3 } contained_by { box { -1, 1 } } max_gradient 1.5 accuracy 0.01 open }
#declare Ball = isosurface { function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.2 } } max_gradient 4 }
#declare Steep = isosurface { function { sin(9*x) } contained_by { sphere { 0, 1 } } max_gradient 2 threshold 0.4 }
All(Right) All(Left) All(Open) All(Ball) All(Steep)
All(object { Right scale 2 }) All(object { Left scale <0.5, 1, 1> })

// expect:  0.304687500 0.302734375 0.304687500 1.000000000 1.000000000
// expect:  -1.000000000 0.303320313 0.302343750 0.000000000 0.000000000
// expect:  0.304687500 0.302734375 0.304687500 0.000000000 0.000000000
// expect:  -0.999609375 1.000539551 1.000444336 1.000737305 1.000302734
// expect:  -1.000000000 -0.393798828 0.000000000 0.303906250 0.758754883
// expect:  0.601562500 0.603515625 0.601562500 0.602500000 0.601367187
// expect:  -0.500000000 0.151171875 0.155468750 0.000000000 0.000000000
