// str pads with blanks, or with zeros for a negative width
#version 3.7;
#debug concat(concat("[", str(3.14159,8,2), "]"), "\n") // expect: [    3.14]
#debug concat(concat("[", str(3.14159,-8,2), "]"), "\n") // expect: [00003.14]
#debug concat(concat("[", str(-3.14159,-8,2), "]"), "\n") // expect: [-0003.14]
#debug concat(concat("[", str(42,0,0), "]"), "\n") // expect: [42]
#debug concat(concat("[", str(12345,3,1), "]"), "\n") // expect: [12345.0]
