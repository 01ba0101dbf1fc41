// Skipped text need not make sense, only balance
#version 3.7;
#if (0)
  undeclared_name(1, 2) sphere { nonsense
  #if (1) "string with #end" #end // #end in a comment
  /* #end */
#else
  #debug "skipped\n" // expect: skipped
#end
