"""Write docs/command-line.md from the table of options: python tests/tools/command_line_page.py."""

from __future__ import annotations

from pathlib import Path

from minipov.option_help import markdown

PAGE = Path(__file__).resolve().parents[2] / "docs/command-line.md"

INTRODUCTION = """# The command line

    minipov scene.pov                          scene.png, beside the scene
    minipov scene.pov -o out.png -W 640 -H 480 -t 4
    minipov scene.pov +W640 +H480 +A0.3 +FN16 +UA +Oout.png
    minipov scene.ini[Low] Declare=Count=5
    minipov - -o out.png < scene.pov           the scene from standard input
    minipov scene.pov +FP +O- | display        the picture to standard output
    minipov check scene.pov --json             what is wrong, without rendering
    minipov diff scene.pov                     the same scene in POV-Ray, compared
    minipov lsp                                the language server, for editors

## How options are written

An option has three spellings that can be mixed: two dashes (`--width 640`, `--width=640`, `--no-antialias`), POV-Ray's
switch (`+W640`; a `-` turns flags off, and is as good as a `+` elsewhere; upper or lower case) and POV-Ray's INI
statement (`Width=640`). Whole numbers may be written as floats. An unknown switch is an error; an unknown INI key is
warned of and ignored.

A word alone is the scene, an INI file (`file.ini`, or a section of it: `file.ini[Section]`), or the name of either
without its extension. An INI file holds statements and switches, comments after `;`, and sections that are read only
when asked for.

Options come first from `$POVINI`, else from `povray.ini` here, else from `~/.povray/3.7/povray.ini`; then from the
arguments, the last one winning. Files that a scene names are looked for here, beside the scene, in `+L` folders, in the
folders of `$POVINC`, and where POV-Ray is installed.

## What comes out

The picture appears under its name when it is complete, never half. A folder as `+O` (or a name that ends in `/`) gets
the scene's name; a missing extension is added; a known extension tells the type, where no `+F` does. Frames have their
number before the extension, with as many digits as the last one has.

Ctrl-C stops within a second, and leaves what is finished as a picture; `+C` goes on from there. For that a file
`picture.png.minipov-state` stays beside the picture until it is complete.

| exit status | |
|---|---|
| 0 | the picture is written |
| 1 | a mistake in the scene, or the picture cannot be written |
| 2 | the command line cannot be understood |
| 130 | interrupted |

`minipov check` ends with 0 for scenes without errors and 1 with; `minipov diff` with 0 within the tolerance, 1 beyond
it, 2 where a picture is missing.

## What is said

Everything is said on standard error. On a terminal there is a progress bar; in a pipe only warnings and errors appear,
unless `+V` asks for the lines by which other programs follow POV-Ray (`==== [Rendering...] ====`,
`Rendered 1024 of 76800 pixels (1%)`). An error is told as `file:line:column: error: message` with the line and a caret;
in a pipe also in POV-Ray's words (`File 'scene.pov' line 3: Parse Error: …`).
"""


def page() -> str:
    """The whole page."""
    return INTRODUCTION + markdown()


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")
