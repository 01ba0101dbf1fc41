// SYNTAX TEST "source.povray" "what each kind of word is coloured as"

#declare Size = 2*pi;
// <------- keyword.control.directive.povray
//       ^^^^ variable.other.declaration.povray
//            ^ keyword.operator.povray
//              ^ constant.numeric.povray
//                ^^ constant.language.povray

#macro Ball(P, R)
//     ^^^^ entity.name.function.povray
  sphere { P, R pigment { rgb <1, .5, 0> } }
//^^^^^^ entity.name.type.block.povray
//         ^ variable.other.povray
//              ^^^^^^^ entity.name.type.block.povray
//                        ^^^ storage.type.color.povray
//                                ^^ constant.numeric.povray
#end
// <---- keyword.control.povray

#if (sin(Size) > 0) Ball(x, 1) #else text { ttf "a\"b.ttf" "c" 1, 0 } #end
//   ^^^ support.function.povray
//                  ^^^^ entity.name.function.call.povray
//                       ^ constant.language.povray
//                             ^^^^^ keyword.control.povray
//                                                ^^ constant.character.escape.povray
//                                          ^^^ support.type.property-name.povray

/* one /* two */ still */ box { 0, 1 finish { phong_size 40 } }
//               ^^^^^ comment.block.povray
//                        ^^^ entity.name.type.block.povray
//                                            ^^^^^^^^^^ support.type.property-name.povray
