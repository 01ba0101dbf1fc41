"""The words that may follow ``#``: a line each, as ``names | how it is written | what it does``."""

from typing import Final

DIRECTIVES: Final = """
break | #break | Leaves the loop, or ends the case.
case | #case (value) | What to do for one value of #switch.
debug | #debug "text" | Prints a text.
declare | #declare NAME = value; | Gives a name a value, everywhere from here on.
default | #default { texture {...} } | What objects and textures start from.
else | #else | What to do if no condition before held.
elseif | #elseif (condition) | Another condition of #if.
end | #end | Ends #if, #ifdef, #ifndef, #switch, #while, #for or #macro.
error | #error "text" | Prints a text and ends the run.
fclose | #fclose NAME | Closes a file.
fopen | #fopen NAME "file" read | Opens a file to read, write or append.
for | #for (NAME, first, last, step) ... #end | Repeats for each value of a variable.
if | #if (condition) ... #elseif (condition) ... #else ... #end | Chooses by a condition.
ifdef | #ifdef (NAME) ... #else ... #end | Chooses by whether a name is declared.
ifndef | #ifndef (NAME) ... #else ... #end | Chooses by whether a name is not declared.
include | #include "file.inc" | Reads another file here.
local | #local NAME = value; | Gives a name a value inside this macro or file.
macro | #macro NAME(parameters) ... #end | Declares a macro.
max_intersections | #max_intersections N | Obsolete.
max_trace_level | #max_trace_level N | Obsolete: stands in global_settings.
range | #range (low, high) | What to do for a range of values of #switch.
read | #read (NAME, variable, ...) | Reads values from a file.
render | #render "text" | Obsolete: prints a text.
statistics | #statistics "text" | Obsolete: prints a text.
switch | #switch (value) #case (value) ... #break #range (low, high) ... #else ... #end | Chooses by a value.
undef | #undef NAME | Forgets a name.
version | #version 3.7; | Says for which version of the language the file is written.
warning | #warning "text" | Prints a warning.
while | #while (condition) ... #end | Repeats as long as a condition holds.
write | #write (NAME, value, ...) | Writes values to a file.
"""
