// Layers of sky as before version 3.7
// class: exact
#version 3.6;
#if (3.6>3.65) global_settings { assumed_gamma 1 } #end
camera { location <0,1,-4> look_at <0,1.5,0> }
light_source{<-5,8,-6> rgb 1}
background{ rgb <.4,.1,.6>}
sky_sphere { pigment{ gradient y color_map{[0 rgb <.2,.4,.1>][1 rgb <.1,.2,.9>]} }
 pigment { bozo color_map{[0 rgbf <1,.8,.9,.7>][.5 rgbt <.5,.4,.3,.8>][1 rgbft <.8,.9,1,.3,.3>]} scale .2 } 
 pigment { checker rgb 1 transmit 1 rgbt <1,0,0,.5> scale .3 } rotate 20*z scale 2 }
sphere{<1,1,0> 1 pigment{rgb .2} finish{reflection .7}}
