"""The one table of options: POV-Ray's INI keys and switches, and minipov's own long options.

Parsing, defaults, `minipov --help` and docs/command-line.md all come from here. Facts were checked against POV-Ray 3.7.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias

Value: TypeAlias = bool | int | float | str
Kind: TypeAlias = Literal["flag", "integer", "number", "place", "text", "file type", "repeated"]
"""``place`` is a pixel counted from 1 (an int) or a share of the picture (a float up to 1)."""
Support: TypeAlias = Literal["honoured", "accepted", "not yet"]
"""``accepted``: understood, and changes nothing in the picture here. ``not yet``: warned of when it is used."""


@dataclass(frozen=True, slots=True)
class Option:
    """One option. ``switch`` is what follows + or -; a flag's switch may carry a value, which goes to ``carries``.

    ``long`` is minipov's spelling after two dashes where it is not the key in lower case with dashes.
    """

    group: str
    key: str
    kind: Kind
    default: Value
    switch: str
    help: str
    carries: str = ""
    support: Support = "honoured"
    aliases: tuple[str, ...] = ()
    long: str = ""

    @property
    def long_name(self) -> str:
        """How the option is spelled after two dashes."""
        return self.long or self.key.lower().replace("_", "-")


_PICTURE, _TEXT, _ANIMATION = "Picture and file", "Scene text", "Animation"
_QUALITY, _STREAMS, _PROGRAM = "Tracing", "Messages", "Program"


def _accepted(group: str, kind: Kind, default: Value, *names: str) -> list[Option]:
    """Options of POV-Ray that have nothing to act on here, as ``Key +switch`` pairs."""
    split = [name.split() for name in names]
    return [
        Option(group, key, kind, default, switch[0] if switch else "", "has no effect here", support="accepted")
        for key, *switch in split
    ]


OPTIONS: tuple[Option, ...] = (
    Option(_PICTURE, "Width", "integer", 800, "W", "width of the picture in pixels"),
    Option(_PICTURE, "Height", "integer", 600, "H", "height of the picture in pixels"),
    Option(_PICTURE, "Output_File_Name", "text", "", "O", "file or folder to write; - is standard output",
           long="output"),
    Option(_PICTURE, "Output_to_File", "flag", True, "F", "write a file, of type N PNG, T TGA, C TGA packed, P PPM, "
           "B BMP, J JPEG, E OpenEXR, H Radiance HDR, with bits per colour: +FN16", carries="Output_File_Type"),
    Option(_PICTURE, "Output_File_Type", "file type", "", "", "letter of the type; else the file's extension tells"),
    Option(_PICTURE, "Bits_Per_Color", "integer", 8, "", "5 to 16, for PNG and PPM", aliases=("Bits_Per_Colour",)),
    Option(_PICTURE, "Output_Alpha", "flag", False, "UA", "keep the background transparent"),
    Option(_PICTURE, "Grayscale_Output", "flag", False, "", "write shades of grey, 16 bits deep"),
    Option(_PICTURE, "File_Gamma", "text", "sRGB", "", "curve of the file: sRGB or a number"),
    Option(_PICTURE, "Compression", "integer", 0, "", "JPEG quality, 2 to 100"),
    Option(_PICTURE, "Start_Column", "place", 1, "SC", "first column to render, counted from 1, or a share below 1"),
    Option(_PICTURE, "End_Column", "place", 1.0, "EC", "last column to render"),
    Option(_PICTURE, "Start_Row", "place", 1, "SR", "first row to render", aliases=("Start_Line",)),
    Option(_PICTURE, "End_Row", "place", 1.0, "ER", "last row to render", aliases=("End_Line",)),
    Option(_PICTURE, "Dither", "flag", False, "TH", "dither the file", carries="Dither_Method"),
    Option(_PICTURE, "Dither_Method", "text", "FS", "", "B2, B3, B4 ordered; D1, D2, FS spread the error"),
    Option(_PICTURE, "Continue_Trace", "flag", False, "C", "go on with an interrupted picture"),
    Option(_PICTURE, "Create_Ini", "text", "", "GI", "write the options in effect to a file"),
    *_accepted(_PICTURE, "text", "", "Display_Gamma", "Histogram_Type", "Histogram_Name",
               "Histogram_Grid_Size"),
    *_accepted(_PICTURE, "integer", 0, "Max_Image_Buffer_Memory MI", "Buffer_Size"),
    *_accepted(_PICTURE, "flag", False, "Buffer_Output", "Create_Histogram", "Create_Continue_Trace_Log CC"),
    Option(_TEXT, "Input_File_Name", "text", "", "I", "the scene; .pov is added; - is standard input", long="input"),
    Option(_TEXT, "Library_Path", "repeated", "", "L", "a further folder for includes, pictures and fonts"),
    Option(_TEXT, "Include_Header", "text", "", "HI", "a file to read before the scene"),
    Option(_TEXT, "Include_Ini", "text", "", "", "a further INI file"),
    Option(_TEXT, "Declare", "repeated", "", "", "Declare=Name=1.5 declares a value for the scene"),
    Option(_TEXT, "Version", "number", 0.0, "MV", "language version until the scene says #version"),
    Option(_ANIMATION, "Clock", "number", 0.0, "K", "value of clock in a single picture"),
    Option(_ANIMATION, "Initial_Frame", "integer", 1, "KFI", "number of the first frame"),
    Option(_ANIMATION, "Final_Frame", "integer", 0, "KFF", "number of the last frame; starts an animation"),
    Option(_ANIMATION, "Initial_Clock", "number", 0.0, "KI", "clock in the first frame"),
    Option(_ANIMATION, "Final_Clock", "number", 1.0, "KF", "clock in the last frame"),
    Option(_ANIMATION, "Subset_Start_Frame", "place", 0, "SF", "first frame to render, or a share below 1"),
    Option(_ANIMATION, "Subset_End_Frame", "place", 0, "EF", "last frame to render, or a share below 1"),
    Option(_ANIMATION, "Frame_Step", "integer", 1, "STP", "render every n-th frame"),
    Option(_ANIMATION, "Cyclic_Animation", "flag", False, "KC", "the frame after the last would be the first"),
    Option(_ANIMATION, "Clockless_Animation", "flag", False, "KLA", "one parse, several cameras", support="not yet"),
    Option(_ANIMATION, "Field_Render", "flag", False, "UF", "render fields of video", support="not yet"),
    *_accepted(_ANIMATION, "flag", False, "Odd_Field UO"),
    Option(_QUALITY, "Quality", "integer", 9, "Q", "0, 1 colours only; 2, 3 light; 4 shadows; 5 area lights; 6, 7 "
           "patterns; 8 reflection; 9 media and radiosity"),
    Option(_QUALITY, "Antialias", "flag", False, "A", "smooth edges; +A0.1 sets the threshold too",
           carries="Antialias_Threshold"),
    Option(_QUALITY, "Antialias_Threshold", "number", 0.3, "", "difference between neighbours that is smoothed"),
    Option(_QUALITY, "Sampling_Method", "integer", 1, "AM", "1 a fixed grid of samples, 2 recursive"),
    Option(_QUALITY, "Antialias_Depth", "integer", 3, "R", "samples in a row (method 1), halvings (method 2), 1 to 9"),
    Option(_QUALITY, "Antialias_Gamma", "number", 2.5, "AG", "gamma at which differences are judged"),
    Option(_QUALITY, "Jitter", "flag", True, "J", "shift the samples at random", carries="Jitter_Amount"),
    Option(_QUALITY, "Jitter_Amount", "number", 1.0, "", "how far samples are shifted"),
    Option(_QUALITY, "Work_Threads", "integer", 0, "WT", "threads to render with; 0 is one per core", aliases=("T",),
           long="threads"),
    Option(_QUALITY, "Accelerator", "text", "octree", "", "how rays find objects: linear, spheres, hierarchy, "
           "grid or octree"),
    Option(_QUALITY, "Radiosity_From_File", "flag", False, "RFI", "load radiosity samples", support="not yet"),
    Option(_QUALITY, "Radiosity_To_File", "flag", False, "RFO", "save radiosity samples", support="not yet"),
    *_accepted(_QUALITY, "text", "", "Radiosity_File_Name RF", "Bounding_Method BM", "Render_Pattern RP",
               "Stochastic_Seed SS", "Antialias_Confidence AC"),
    *_accepted(_QUALITY, "flag", False, "High_Reproducibility HR", "Radiosity_Vain_Pretrace RVP", "Remove_Bounds UR",
               "Split_Unions SU", "Draw_Vistas UD", "Vista_Buffer UV", "Light_Buffer UL"),
    Option(_QUALITY, "Bounding", "flag", True, "MB", "has no effect here", carries="Bounding_Threshold",
           support="accepted"),
    *_accepted(_QUALITY, "integer", 0, "Bounding_Threshold B", "Render_Block_Size BS", "Render_Block_Step RS"),
    *_accepted(_QUALITY, "number", 0.0, "BSP_MaxDepth", "BSP_BaseAccessCost", "BSP_ChildAccessCost", "BSP_ISectCost",
               "BSP_MissChance"),
    Option(_STREAMS, "Verbose", "flag", False, "V", "print progress and times, as POV-Ray does"),
    Option(_STREAMS, "Statistics", "flag", False, "", "print counts of rays and tests, and times"),
    Option(_STREAMS, "All_Console", "flag", True, "GA", "print messages; +GAfile writes them to a file too",
           carries="All_File"),
    Option(_STREAMS, "Debug_Console", "flag", True, "GD", "print what #debug says", carries="Debug_File"),
    Option(_STREAMS, "Fatal_Console", "flag", True, "GF", "print errors", carries="Fatal_File"),
    Option(_STREAMS, "Render_Console", "flag", True, "GR", "print what #render says", carries="Render_File"),
    Option(_STREAMS, "Statistic_Console", "flag", True, "GS", "print statistics", carries="Statistic_File"),
    Option(_STREAMS, "Warning_Console", "flag", True, "GW", "print warnings", carries="Warning_File"),
    Option(_STREAMS, "All_File", "text", "", "", "file for all messages"),
    Option(_STREAMS, "Debug_File", "text", "", "", "file for what #debug says"),
    Option(_STREAMS, "Fatal_File", "text", "", "", "file for errors"),
    Option(_STREAMS, "Render_File", "text", "", "", "file for what #render says"),
    Option(_STREAMS, "Statistic_File", "text", "", "", "file for statistics", aliases=("Statistics_File",)),
    Option(_STREAMS, "Warning_File", "text", "", "", "file for warnings"),
    Option(_STREAMS, "Append_File", "flag", False, "GP", "add to these files"),
    Option(_STREAMS, "Warning_Level", "integer", 10, "WL", "0 prints no warnings"),
    Option(_PROGRAM, "Help", "flag", False, "?", "print this help"),
    Option(_PROGRAM, "Program_Version", "flag", False, "", "print the program's version", long="version"),
    *_accepted(_PROGRAM, "flag", False, "Display D", "Pause_When_Done P", "Test_Abort X", "Real_Time_Raytracing RTR"),
    *_accepted(_PROGRAM, "text", "", "Video_Mode", "Palette", "Preview_Start_Size SP", "Preview_End_Size EP",
               "Test_Abort_Count"),
    *(
        Option(_PROGRAM, f"{moment}_Command", "text", "", "", "a command for the shell, with %o %s %n %k %w %h")
        for moment in ("Pre_Scene", "Pre_Frame", "Post_Frame", "Post_Scene", "User_Abort", "Fatal_Error")
    ),
    *(
        Option(_PROGRAM, f"{moment}_Return", "text", "", "", "what follows when it fails: I ignore, S skip the frame, "
               "A skip all, Q quit, U abort, F fail; after - when it succeeds")
        for moment in ("Pre_Scene", "Pre_Frame", "Post_Frame", "Post_Scene", "User_Abort", "Fatal_Error")
    ),
)  # fmt: skip

BY_KEY = {name.lower(): option for option in OPTIONS for name in (option.key, *option.aliases)}
BY_SWITCH = {option.switch.lower(): option for option in OPTIONS if option.switch} | {"t": BY_KEY["work_threads"]}
BY_LONG_NAME = {option.long_name: option for option in OPTIONS}
