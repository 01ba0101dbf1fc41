// A font file that does not exist
// error: 4:12 'nowhere.ttf'
#version 3.7;
text { ttf "nowhere.ttf" "a" 1, 0 }
