// States by frame number, data read from a file in a loop, macros named after addresses
#version 3.7;
global_settings { ambient_light rgb <1,1,1> assumed_gamma 1 }
#declare contacts_show = true;
#macro sh_55a9d2(pos, qua) object { box { -0.5, 0.5 } translate pos }
#end
#fopen Out "state00000.dat" write
#write (Out, 1, ",", 0.5, ",", -2.25, ",\n", 2, ",", 1.5, ",", 3e-1, ",\n", "\"end\"", ",\n")
#fclose Out
#fopen MyDatFile concat("state", str(frame_number, -5, 0), ".dat") read
#declare Turns = 0;
#while (defined(MyDatFile))
  #read (MyDatFile, Id, PX, PY)
  #declare Turns = Turns + 1;
  #if (Turns = 2) #read (MyDatFile, Tail) #fclose MyDatFile #end
  sh_55a9d2(<PX, PY, Id>, 0)
#end
#debug concat(str(Turns, 0, 0), " ", str(PX, 0, 2), " ", str(PY, 0, 2), "\n") // expect: 2 1.50 0.30
