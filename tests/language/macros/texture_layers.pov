// A macro that makes layered textures
#version 3.7;
#macro L() texture{pigment{rgb 1}} texture{pigment{rgbt 1}} #end
#declare T = L()
#debug "ok\n" // expect: ok
