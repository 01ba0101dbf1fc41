"""The words that are values or functions: a line each, as ``names | signature | what it is``; synonyms share a line."""

from typing import Final

CONSTANTS: Final = """
x | | the vector <1,0,0>
y | | the vector <0,1,0>
z | | the vector <0,0,1>
u | | the 2-vector <1,0>
v | | the 2-vector <0,1>
t | | the 4-vector <0,0,0,1>
pi | | 3.14159265358979
true yes on | | 1
false no off | | 0
clock | | the animation clock, +K on the command line
clock_on | | 1 in an animation or when +K was given
clock_delta | | how much the clock grows from frame to frame
frame_number | | number of the current frame
initial_frame | | first frame of the animation
final_frame | | last frame of the animation
initial_clock | | clock at the first frame
final_clock | | clock at the last frame
image_width | | width of the picture in pixels
image_height | | height of the picture in pixels
version | | the language version in force
input_file_name | | name of the main scene file
now | | days since 2000-01-01 00:00 UTC
"""

CONSTANTS_38: Final = "tau | | 2*pi"

UNARY_FUNCTIONS: Final = """
abs | abs(A) | absolute value
acos | acos(A) | arc cosine, in radians
acosh | acosh(A) | inverse hyperbolic cosine
asin | asin(A) | arc sine, in radians
asinh | asinh(A) | inverse hyperbolic sine
atan | atan(A) | arc tangent, in radians
atanh | atanh(A) | inverse hyperbolic tangent
ceil | ceil(A) | smallest integer not below A
cos | cos(A) | cosine of A radians
cosh | cosh(A) | hyperbolic cosine
degrees | degrees(A) | radians to degrees
exp | exp(A) | e to the power A
floor | floor(A) | largest integer not above A
int | int(A) | A cut towards zero
ln | ln(A) | natural logarithm
log | log(A) | logarithm to base 10
radians | radians(A) | degrees to radians
rand | rand(stream) | next number in 0..1 of a random stream
seed | seed(N) | opens a random stream
sin | sin(A) | sine of A radians
sinh | sinh(A) | hyperbolic sine
sqrt | sqrt(A) | square root
tan | tan(A) | tangent of A radians
tanh | tanh(A) | hyperbolic tangent
"""

FUNCTIONS: Final = """
asc | asc(S) | code of the first character of S
atan2 | atan2(A, B) | angle of the point (B, A), in radians
bitwise_and | bitwise_and(A, B, ...) | bits set in all
bitwise_or | bitwise_or(A, B, ...) | bits set in any
bitwise_xor | bitwise_xor(A, B, ...) | bits set in an odd number of them
chr | chr(N) | the character with code N
concat | concat(S, ...) | strings put together
datetime | datetime(days, format) | a date and time as text
defined | defined(NAME) | 1 if the name is declared
dimension_size | dimension_size(ARRAY, N) | size of an array's dimension N, from 1
dimensions | dimensions(ARRAY) | how many dimensions an array has
div | div(A, B) | integer part of A/B
file_exists | file_exists(S) | 1 if the file is found
inside | inside(OBJECT, P) | 1 if the point is inside the object
max | max(A, B, ...) | the largest
max_extent | max_extent(OBJECT) | upper corner of the object's bounding box
min | min(A, B, ...) | the smallest
min_extent | min_extent(OBJECT) | lower corner of the object's bounding box
mod | mod(A, B) | remainder of A/B, with A's sign
pow | pow(A, B) | A to the power B
prod | prod(i, first, last, expression) | product over i, in functions
select | select(A, B, C, D) | B, C or D as A is below, at or above 0; with three, B below and C else
sqr | sqr(A) | A*A (3.8); the square in a julia_fractal
str | str(A, length, precision) | a float as text
strcmp | strcmp(S, T) | -1, 0 or 1 as S sorts before, with or after T
strlen | strlen(S) | number of characters
strlwr | strlwr(S) | S in lower case
strupr | strupr(S) | S in upper case
substr | substr(S, position, length) | part of S, positions from 1
sum | sum(i, first, last, expression) | sum over i, in functions
trace | trace(OBJECT, from, direction, NORMAL) | where a ray first meets the object; the normal goes into NORMAL
val | val(S) | the number that S begins with
vaxis_rotate | vaxis_rotate(V, axis, degrees) | V turned about an axis
vcross | vcross(A, B) | cross product
vdot | vdot(A, B) | dot product
vlength | vlength(V) | length of V
vnormalize | vnormalize(V) | V with length one
vrotate | vrotate(V, degrees) | V turned about x, then y, then z
vstr | vstr(N, V, separator, length, precision) | a vector as text
vturbulence | vturbulence(lambda, omega, octaves, P) | turbulence at a point
"""

RGB: Final = """
rgb | rgb <R,G,B> | a colour
rgbf | rgbf <R,G,B,F> | a colour that filters light
rgbt | rgbt <R,G,B,T> | a colour that transmits light
rgbft | rgbft <R,G,B,F,T> | a colour that filters and transmits light
srgb | srgb <R,G,B> | a colour given in sRGB
srgbf | srgbf <R,G,B,F> | a filtering colour given in sRGB
srgbt | srgbt <R,G,B,T> | a transmitting colour given in sRGB
srgbft | srgbft <R,G,B,F,T> | a filtering and transmitting colour given in sRGB
"""
