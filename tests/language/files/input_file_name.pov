// The name of the main file
#version 3.7;
#debug concat(substr(input_file_name, strlen(input_file_name) - 18, 19), "\n") // expect: input_file_name.pov
