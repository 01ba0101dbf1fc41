"""`minipov --help` and docs/command-line.md, made from the table of options."""

from __future__ import annotations

from itertools import groupby

from minipov.option_table import OPTIONS, Option

_USAGE = """\
usage: minipov SCENE.pov|FILE.ini[Section] [options]
       minipov check SCENE.pov ... [--json]
       minipov diff A.png B.png | SCENE.pov | FOLDER
       minipov lsp

Options can be written as POV-Ray's switches (+W640, -D), as INI statements (Width=640) or with two dashes
(--width 640, --no-antialias). Includes are looked for beside the scene, in the current folder, in +L folders, in POVINC
and where POV-Ray is installed.
"""


def help_text() -> str:
    """Return the text of `minipov --help`."""
    lines = [_USAGE]
    for group, options in groupby(_shown(), key=lambda option: option.group):
        lines += [f"{group}:", *(_line(option) for option in options), ""]
    accepted = [option.key for option in OPTIONS if option.support == "accepted"]
    lines.append("Accepted without effect: " + ", ".join(accepted))
    return "\n".join(lines)


def markdown() -> str:
    """Return the tables of docs/command-line.md."""
    lines: list[str] = []
    for group, options in groupby(_shown(), key=lambda option: option.group):
        lines += [f"\n## {group}\n", "| option | INI key | switch | default | meaning |", "|---|---|---|---|---|"]
        for option in options:
            switch = f"`+{option.switch}`" if option.switch else ""
            default = "" if option.default == "" else f"`{_shown_default(option)}`"
            lines.append(f"| `--{option.long_name}` | `{option.key}` | {switch} | {default} | {_meaning(option)} |")
    accepted = ", ".join(f"`{option.key}`" for option in OPTIONS if option.support == "accepted")
    return "\n".join([*lines, f"\nAccepted, without effect: {accepted}.", ""])


def _shown() -> list[Option]:
    return [option for option in OPTIONS if option.support != "accepted"]


def _line(option: Option) -> str:
    switch = f"+{option.switch}" if option.switch else ""
    return f"  --{option.long_name:<24}{switch:<6}{_meaning(option)}"


def _meaning(option: Option) -> str:
    return option.help + (" (not supported yet)" if option.support == "not yet" else "")


def _shown_default(option: Option) -> str:
    return ("on" if option.default else "off") if isinstance(option.default, bool) else str(option.default)
