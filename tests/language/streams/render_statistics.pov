// #render and #statistics are old names of the debug stream
#version 3.7;
#render "rendering\n"
#statistics "counting\n"

// expect: rendering
// expect: counting
