// The size of the image
#version 3.7;
#debug concat(str(image_width, 0, 6), "\n") // expect: 1.000000
#debug concat(str(image_height, 0, 6), "\n") // expect: 1.000000
