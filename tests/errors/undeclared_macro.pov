// A call of a macro that does not exist
// error: 4:14 'Twiddle'
#version 3.7;
#declare A = Twiddle(1, 2);
