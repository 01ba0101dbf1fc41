// A macro may supply several components
#version 3.7;
#macro Two() 1,2 #end
#macro Three() 7,8,9 #end
#debug concat(vstr(3, <Two(),3>, ",", 0, 6), "\n") // expect: 1.000000,2.000000,3.000000
#debug concat(vstr(3, <Three()>, ",", 0, 6), "\n") // expect: 7.000000,8.000000,9.000000
