// #write on a handle opened for reading
// error: 5:1
#version 3.7;
#fopen In "numbers.txt" read
#write (In, 1)
