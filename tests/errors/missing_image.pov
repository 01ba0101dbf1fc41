// An image file that does not exist
// error: 4:41 'nowhere.png'
#version 3.7;
sphere { 0, 1 pigment { image_map { png "nowhere.png" } } }
