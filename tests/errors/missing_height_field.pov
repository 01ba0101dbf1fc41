// A height field from a file that does not exist
// error: 4:20 'nowhere.png'
#version 3.7;
height_field { png "nowhere.png" }
