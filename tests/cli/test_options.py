"""POV-Ray's switches, INI files and long options, read into one set of values."""

from pathlib import Path

import pytest

from minipov.frames import frames
from minipov.image_format import FileFormat
from minipov.include_path import startup_ini
from minipov.option_help import help_text, markdown
from minipov.option_table import OPTIONS, Option
from minipov.option_writer import write_ini
from minipov.options import CommandLine, UsageError, parse_command_line
from minipov.output_name import file_format, output_path
from minipov.pipeline import render_settings


def parsed(*words: str) -> CommandLine:
    return parse_command_line(words)


@pytest.fixture(autouse=True)
def _in_an_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize(
    ("words", "key", "value"),
    [
        (["+W64"], "Width", 64),
        (["-w64"], "Width", 64),
        (["+H", "48"], "Height", 48),
        (["Width=64.0"], "Width", 64),
        (["width = 64.7"], "Width", 64),
        (["--width", "64"], "Width", 64),
        (["--width=64"], "Width", 64),
        (["+a0.05"], "Antialias_Threshold", 0.05),
        (["+A"], "Antialias", True),
        (["-A"], "Antialias", False),
        (["--no-antialias"], "Antialias", False),
        (["Antialias=off"], "Antialias", False),
        (["Antialias=YES"], "Antialias", True),
        (["+AM2"], "Sampling_Method", 2),
        (["+R4"], "Antialias_Depth", 4),
        (["+J0.5"], "Jitter_Amount", 0.5),
        (["-J"], "Jitter", False),
        (["+Q5"], "Quality", 5),
        (["+WT3"], "Work_Threads", 3),
        (["-t", "3"], "Work_Threads", 3),
        (["--threads", "3"], "Work_Threads", 3),
        (["+UA"], "Output_Alpha", True),
        (["-F"], "Output_to_File", False),
        (["+FT"], "Output_File_Type", "T"),
        (["+FN16"], "Bits_Per_Color", 16),
        (["+FPg"], "Grayscale_Output", True),
        (["+FJ50"], "Compression", 50),
        (["+SR0.5"], "Start_Row", 0.5),
        (["+ER12"], "End_Row", 12),
        (["+K0.5"], "Clock", 0.5),
        (["+KFI3"], "Initial_Frame", 3),
        (["+KFF12"], "Final_Frame", 12),
        (["+KI2"], "Initial_Clock", 2.0),
        (["+KF4"], "Final_Clock", 4.0),
        (["+KC"], "Cyclic_Animation", True),
        (["+STP2"], "Frame_Step", 2),
        (["+V"], "Verbose", True),
        (["-GDdebug.txt"], "Debug_File", "debug.txt"),
        (["-GD"], "Debug_Console", False),
        (["+MV3.5"], "Version", 3.5),
        (["+HIa.inc"], "Include_Header", "a.inc"),
        (['+I"a b.pov"'], "Input_File_Name", "a b.pov"),
        (["-Ob.png"], "Output_File_Name", "b.png"),
        (["-o", "b.png"], "Output_File_Name", "b.png"),
        (["+O-"], "Output_File_Name", "-"),
        (["scene.pov"], "Input_File_Name", "scene.pov"),
        (["-version"], "Program_Version", True),
        (["-help"], "Help", True),
        (["+TH"], "Dither", True),
        (["+THD1"], "Dither_Method", "D1"),
        (["+C"], "Continue_Trace", True),
    ],
)
def test_one_option(words: list[str], key: str, value: object) -> None:
    command = parsed(*words)
    assert command.values[key] == value
    assert command.warnings == []


@pytest.mark.parametrize("option", [option for option in OPTIONS if option.switch], ids=lambda option: option.key)
def test_every_switch_is_accepted(option: Option) -> None:
    values = {"flag": "", "text": "x", "file type": "N"}
    value = values.get(option.kind, "1")
    for sign in "+-":
        assert option.key in parsed(f"{sign}{option.switch}{value}").given


@pytest.mark.parametrize("option", OPTIONS, ids=lambda option: option.key)
def test_every_key_is_accepted(option: Option) -> None:
    Path("other.ini").write_text("")
    values = {"Declare": "A=1", "Output_File_Type": "N", "Include_Ini": "other.ini", "File_Gamma": "sRGB"}
    assert option.key in parsed(f"{option.key.upper()}={values.get(option.key, '1')}").given


def test_an_ini_file_with_sections() -> None:
    Path("a.ini").write_text(
        'Input_File_Name="my scene.pov" ; the scene\n'
        "Width=100 \n+H50 -D +A0.2\nLibrary_Path='some where'\nDeclare=Count=5\n"
        "[Low]\nWidth=10\n[High]\nWidth=1000\n"
    )
    plain, low = parsed("a.ini"), parsed("a.ini[low]", "+Q3")
    assert (plain.integer("Width"), plain.integer("Height"), low.integer("Width")) == (100, 50, 10)
    assert plain.text("Input_File_Name") == "my scene.pov"
    assert plain.library_paths == [Path("some where")]
    assert plain.declares == {"Count": 5.0}
    assert low.number("Antialias_Threshold") == 0.2
    assert low.integer("Quality") == 3


def test_an_ini_file_is_found_without_its_extension() -> None:
    Path("small.ini").write_text("Width=7")
    assert parsed("small").integer("Width") == 7


def test_ini_files_may_include_others() -> None:
    Path("outer.ini").write_text("Width=1\nInclude_Ini=inner.ini\nHeight=4")
    Path("inner.ini").write_text("Width=3\nHeight=3")
    command = parsed("outer.ini")
    assert (command.integer("Width"), command.integer("Height")) == (3, 4)


def test_ini_files_that_include_each_other_end() -> None:
    Path("a.ini").write_text("Include_Ini=a.ini")
    with pytest.raises(UsageError, match="include each other"):
        parsed("a.ini")


@pytest.mark.parametrize("value", ["2*3", "2 ", "2.0"])
def test_a_declared_number_is_read_as_far_as_it_goes(value: str) -> None:
    assert parsed(f"Declare=A={value}").declares == {"A": 2.0}


def test_a_declared_string() -> None:
    assert parsed('Declare=A="text"').declares == {"A": "text"}


def test_unknown_keys_are_warned_of() -> None:
    command = parsed("Wdith=100", "Width=50")
    assert command.warnings == ["unknown option Wdith is ignored; did you mean Width?"]
    assert command.integer("Width") == 50


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["+ZZ"], "unknown switch"),
        (["--widht=3"], "did you mean --width"),
        (["+W"], "needs a value"),
        (["+Wide"], "is not a number"),
        (["+FX"], "unknown type of output file"),
        (["none.ini"], "no INI file none.ini"),
        (["Declare=A=x"], "is not a number"),
        (["."], "is a folder"),
    ],
)
def test_mistakes(words: list[str], message: str) -> None:
    with pytest.raises(UsageError, match=message):
        parsed(*words)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["+W0"], "0 by 600"),
        (["+W1000000", "+H1000000"], "cannot be made"),
        (["+AM3"], "1 and 2 are possible"),
        (["+SR300", "+ER200"], "nothing of 600 is left"),
    ],
)
def test_options_that_cannot_be_rendered(words: list[str], message: str) -> None:
    with pytest.raises(UsageError, match=message):
        render_settings(parsed(*words))


def test_written_options_can_be_read_again() -> None:
    words = ["+W64", "+H48", "+A0.2", "+FN16", "+UA", "+Ia b.pov", "+Lsome where", "Declare=A=2.5", "+KFF3", "-J"]
    command = parsed(*words)
    write_ini(command, Path("written.ini"))
    again = parsed("written.ini")
    assert again.values == command.values
    assert again.declares == command.declares
    assert again.library_paths == command.library_paths


# --- names of pictures ---


@pytest.mark.parametrize(
    ("words", "name"),
    [
        ([], "scene.png"),
        (["+Oother"], "other.png"),
        (["+Oother.tga"], "other.tga"),
        (["+Ofolder/"], "folder/scene.png"),
        (["+Oa.b"], "a.b.png"),
        (["+FT"], "scene.tga"),
        (["+FP", "+Oout"], "out.ppm"),
        (["+FE"], "scene.exr"),
        (["+FH"], "scene.hdr"),
        (["+FJ"], "scene.jpg"),
        (["+FB"], "scene.bmp"),
        (["+FC"], "scene.tga"),
        (["+FT", "+Oa.png"], "a.png"),
        (["+KFF3"], "scene1.png"),
        (["+KFF10"], "scene01.png"),
        (["+KFF120", "+Of.png"], "f001.png"),
    ],
)
def test_output_names(words: list[str], name: str) -> None:
    command = parsed("scene.pov", *words)
    kind = file_format(command).kind
    assert output_path(command, Path("scene.pov"), frames(command)[0], kind) == Path(name)


def test_a_folder_that_exists_needs_no_slash() -> None:
    Path("folder").mkdir()
    command = parsed("scene.pov", "+Ofolder")
    assert output_path(command, Path("scene.pov"), frames(command)[0], "png") == Path("folder/scene.png")


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["+Oa.exr"], FileFormat("exr")),
        (["+FN16", "+UA"], FileFormat("png", 16, alpha=True)),
        (["+FPg"], FileFormat("ppm", 16, gray=True)),
        (["File_Gamma=1.8"], FileFormat(gamma=1.8)),
        (["+FJ", "Compression=1"], FileFormat("jpeg", quality=85)),
    ],
)
def test_file_formats(words: list[str], expected: FileFormat) -> None:
    assert file_format(parsed(*words)) == expected


# --- animation ---


def test_frames_and_clocks() -> None:
    made = frames(parsed("+KFI2", "+KFF4", "+KI0", "+KF1"))
    assert [(frame.frame_number, frame.clock) for frame in made] == [(2, 0.0), (3, 0.5), (4, 1.0)]
    assert all(frame.clock_on for frame in made)


def test_a_cyclic_animation_stops_before_its_start() -> None:
    made = frames(parsed("+KFF10", "+KC"))
    assert made[8].clock == pytest.approx(0.8)
    assert made[9].clock == pytest.approx(0.9)


@pytest.mark.parametrize(
    ("words", "numbers"),
    [
        (["+SF3", "+EF5"], [3, 4, 5]),
        (["+SF0.5"], [5, 6, 7, 8, 9, 10]),
        (["+STP4"], [1, 5, 9]),
        (["+EF2"], [1, 2]),
    ],
)
def test_parts_of_an_animation(words: list[str], numbers: list[int]) -> None:
    assert [frame.frame_number for frame in frames(parsed("+KFF10", *words))] == numbers


def test_a_still_has_the_clock_it_is_given() -> None:
    assert [(frame.clock, frame.clock_on) for frame in frames(parsed("+K0.25"))] == [(0.25, True)]
    assert [(frame.clock, frame.clock_on) for frame in frames(parsed())] == [(0.0, False)]


# --- where options and includes come from ---


def test_povini_goes_before_the_folder_and_the_user(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    home = tmp_path / "home"
    users = home / ".povray/3.7/povray.ini"
    users.parent.mkdir(parents=True)
    monkeypatch.setenv("HOME", str(home))
    monkeypatch.delenv("POVINI", raising=False)
    assert startup_ini() == []
    users.write_text("Width=3")
    assert startup_ini() == [users]
    Path("povray.ini").write_text("Width=2")
    assert startup_ini() == [Path("povray.ini")]
    named = tmp_path / "named.ini"
    named.write_text("Width=1\nNonsense=2")
    monkeypatch.setenv("POVINI", str(named))
    assert startup_ini() == [named]
    command = parse_command_line(["+H5"], startup_ini())
    assert (command.integer("Width"), command.integer("Height"), command.warnings) == (1, 5, [])


# --- help ---


def test_help_and_page_name_every_option() -> None:
    for option in OPTIONS:
        assert option.key in markdown()
        if option.support != "accepted":
            assert f"--{option.long_name} " in help_text()
