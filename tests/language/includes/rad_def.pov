// Radiosity settings by name
#version 3.7;
#include "rad_def.inc"
global_settings { assumed_gamma 1 radiosity { Rad_Settings(Radiosity_Default, off, off) } }
global_settings { radiosity { Rad_Settings(Radiosity_OutdoorHQ, on, off) } }
#debug concat(str(Radiosity_Debug, 0, 0), str(Radiosity_IndoorLQ, 3, 0), str(Radiosity_Final, 3, 0), "\n")
// expect:
// expect: Radiosity_Default in use
// expect:
// expect: Radiosity_OutdoorHQ in use
// expect: 1  9  5
