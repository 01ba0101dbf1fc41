// A rainbow stands behind media, media behind fog
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 5, -10> look_at <0, 9, 0> angle 90 }
light_source { <3, 20, -20>, rgb 1 }
background { rgb <0.4, 0.5, 0.7> }
plane { y, 0 hollow pigment { checker rgb 0.9 rgb 0.6 scale 4 } }
plane { z, 100 hollow pigment { rgb 0.3 } }
rainbow {
  angle 32 width 9 distance 10 direction <-0.2, -0.2, 1>
  color_map { [0 rgbt <1, 0, 0, 0.5>] [0.5 rgbt <0, 1, 0, 0.5>] [1 rgbt <0, 0, 1, 0.5>] }
}
media { absorption 0.01 emission <0.01, 0, 0.005> }
fog { distance 200 rgb <0.5, 0.3, 0.2> }
