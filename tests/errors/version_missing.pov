// A scene without #version only warns
// warning: 3:1 #version
sphere { 0, 1 }
