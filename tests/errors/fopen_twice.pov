// A handle opened twice
// error: 5:1 'In'
#version 3.7;
#fopen In "numbers.txt" read
#fopen In "numbers.txt" read
