// Animation variables of a still
#version 3.7;
#debug concat(str(clock, 0, 6), "\n") // expect: 0.000000
#debug concat(str(clock_delta, 0, 6), "\n") // expect: 0.000000
#debug concat(str(clock_on, 0, 6), "\n") // expect: 0.000000
#debug concat(str(frame_number, 0, 6), "\n") // expect: 0.000000
#debug concat(str(initial_frame, 0, 6), "\n") // expect: 0.000000
#debug concat(str(final_frame, 0, 6), "\n") // expect: 0.000000
#debug concat(str(initial_clock, 0, 6), "\n") // expect: 0.000000
#debug concat(str(final_clock, 0, 6), "\n") // expect: 0.000000
