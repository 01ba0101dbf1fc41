// A file to read that does not exist
// error: 4:11 'nowhere.txt'
#version 3.7;
#fopen In "nowhere.txt" read
