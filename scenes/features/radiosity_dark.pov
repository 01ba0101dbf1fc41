// No light is gathered for surfaces too dark to show it, whatever adc_bailout of radiosity says
// class: close — gathering is random
#version 3.7;
global_settings {
  assumed_gamma 1
  adc_bailout 0.1
  radiosity { pretrace_start 0.08 pretrace_end 0.02 count 100 nearest_count 5 error_bound 0.4 recursion_limit 1 adc_bailout 0.001 }
}
camera { location <0, 2, -7> look_at <0, 1, 0> }
sky_sphere { pigment { rgb 3 } }
plane { y, 0 pigment { checker rgb 0.12, rgb 0.22 } }
sphere { <-1.2, 1, 0>, 1 pigment { gradient y color_map { [0 rgb 0.3] [1 rgb 0.05] } } finish { diffuse 0.7 } }
box { <0.4, 0, -0.6>, <1.6, 1.6, 0.6> pigment { rgb <0, 0, 0.9> } rotate 20 * y }
