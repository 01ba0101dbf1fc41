// A scene without #version only warns
// warning: 1:1 #version
sphere { 0, 1 }
