// An image file that is no image
// error: 4:54 broken.png
#version 3.7;
sphere { 0, 1 pigment { image_map { png "broken.png" } } }
