#version 3.7; global_settings{assumed_gamma 1}
#declare J = julia_fractal { <-0.2,0.3,0.1,0.05> hypercomplex cos max_iteration 6 precision 20  }
#declare S=seed(3); #declare N=0; #declare H=0;
#for(I,1,60)
#local D=vnormalize(<rand(S)-.5,rand(S)-.5,rand(S)-.5>);
#local T=<rand(S)-.5,rand(S)-.5,rand(S)-.5>*2;
#local O=T-D*(5+I/30);
#local Nn=<0,0,0>;
#local P=trace(J,O,D,Nn);
#debug concat("T ",str(I,0,0)," ",#if(vlength(Nn)=0) "miss" #else concat(str(vlength(P-O),0,9)," ",vstr(3,Nn," ",0,6)) #end,"\n")
#local Q=<rand(S)-.5,rand(S)-.5,rand(S)-.5>*6;
#debug concat("I ",str(I,0,0)," ",str(inside(J,Q),0,0),"\n")
#end
