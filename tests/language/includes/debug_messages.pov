// Messages that a scene can switch on
#version 3.7;
global_settings { assumed_gamma 1 }
#include "debug.inc"
Debug_Message("hidden\n")
Set_Debug(true)
Debug_Message("shown\n")
Debug((1 > 2), "not this\n")
Debug((2 > 1), "but this\n")
Set_Debug(false)
Debug((2 > 1), "nor this\n")
// expect: hidden
// expect: shown
// expect: but this
// expect: nor this
