// A camera and a light by identifier
#version 3.7;
#declare C = camera { location <0,0,-3> look_at 0 }
#declare L = light_source { <1,2,3>, rgb 1 }
camera { C translate x }
light_source { L translate y }
#debug "ok\n" // expect: ok
