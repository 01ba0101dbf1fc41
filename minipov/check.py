"""`minipov check scene.pov`: what is wrong with a scene, without rendering it.

::

    minipov check scene.pov
    minipov check *.pov +L../library --json

A text that cannot be parsed has all its mistakes told, by parsing on after each. Else the scene is run, which tells the
warnings and the mistakes, going on with the next statement where that makes sense; what looks wrong behind the last one
follows as warnings. Options are those of a render.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from minipov.exit_status import OK, SCENE_ERROR, USAGE_ERROR
from minipov.frames import frames
from minipov.grammar.text import decode
from minipov.include_path import startup_ini
from minipov.interpreter import Messages, SdlError, format_error, mistakes
from minipov.interpreter.errors import Place
from minipov.options import CommandLine, UsageError, parse_command_line
from minipov.pipeline import load_options

if TYPE_CHECKING:
    from minipov.editor.analysis.document import Document
    from minipov.grammar import SdlSyntaxError


@dataclass(frozen=True, slots=True)
class Finding:
    """One remark; lines and columns are counted from 1, 0 where the place is not known.

    ``stack`` lists the open macro calls and includes, the innermost first, with the place of each call.
    """

    severity: Literal["error", "warning"]
    file: str
    line: int
    column: int
    message: str
    hint: str | None = None
    stack: tuple[tuple[str, Place], ...] = ()


def main(arguments: Sequence[str]) -> int:
    """Run ``minipov check`` and return 0 for scenes without errors, 1 with, 2 for a wrong use."""
    scenes = [word for word in arguments if Path(word).suffix.lower() in (".pov", ".inc")]
    words = [word for word in arguments if word not in scenes and word != "--json"]
    try:
        command = parse_command_line(words, startup_ini())
    except UsageError as error:
        print(f"minipov check: {error}", file=sys.stderr)
        return USAGE_ERROR
    if not scenes:
        print("usage: minipov check SCENE.pov ... [--json] [options of a render]", file=sys.stderr)
        return USAGE_ERROR
    findings = [finding for scene in scenes for finding in check(Path(scene), command)]
    if "--json" in arguments:
        print(json.dumps([asdict(finding) for finding in findings], indent=1))
    else:
        for finding in findings:
            print(_described(finding))
    return SCENE_ERROR if any(finding.severity == "error" for finding in findings) else OK


def check(scene: Path, command: CommandLine) -> list[Finding]:
    """Return what is wrong with ``scene``, loaded with the options of ``command``."""
    # Only `check` always needs the grammar: scenes that are rendered may be compiled already.
    from minipov.grammar import SdlSyntaxError, parse

    try:
        text = decode(scene.read_bytes())
    except OSError as error:
        return [Finding("error", str(scene), 0, 0, f"cannot be read: {error.strerror}")]
    try:
        parse(text, str(scene))
    except SdlSyntaxError as error:
        return _syntax(scene, text, error)
    return [] if scene.suffix.lower() == ".inc" else _run(scene, text, command)


def _syntax(scene: Path, text: str, error: SdlSyntaxError) -> list[Finding]:
    """What stops the parser, and what it stumbles over when it goes on."""
    from minipov.editor.analysis.document import Document
    from minipov.editor.analysis.syntax import syntax_problems

    document = Document(text, str(scene))
    first = Finding("error", str(scene), error.line, error.column, error.message, error.hint)
    found = {(first.line, first.column): first}
    for problem in syntax_problems(document):
        line, column = _line_and_column(document, problem.start)
        found.setdefault((line, column), Finding("error", str(scene), line, column, problem.message, problem.hint))
    return [found[place] for place in sorted(found)]


def _run(scene: Path, text: str, command: CommandLine) -> list[Finding]:
    """What the scene says when it runs; where it stops before its end, also what looks wrong behind that."""
    messages = Messages()
    errors = mistakes(scene, load_options(command, frames(command)[0], {}), messages)
    failed = [Finding("error", *error.place, error.message, error.hint, error.stack) for error in errors]
    if errors:
        file, *last = errors[-1].place
        behind = last if file == str(scene) else [0, 0]
        failed += [one for one in _suspected(scene, text, command) if [one.line, one.column] > behind]
    warned = [message for message in messages.all if message.kind == "warning"]
    return [Finding("warning", *message.place, message.text) for message in warned] + failed


def _suspected(scene: Path, text: str, command: CommandLine) -> list[Finding]:
    from minipov.editor.analysis.checks import problems
    from minipov.editor.analysis.document import Document
    from minipov.editor.analysis.library import Library
    from minipov.include_path import library_folders

    document = Document(text, str(scene))
    library = Library((*command.library_paths, *library_folders()))
    return [
        Finding("warning", str(scene), *_line_and_column(document, problem.start), problem.message, problem.hint)
        for problem in problems(document, library)
    ]


def _line_and_column(document: Document, offset: int) -> tuple[int, int]:
    line = document.line_of(offset)
    return line + 1, offset - document.line_starts[line] + 1


def _described(finding: Finding) -> str:
    """The finding as people read it, with the line of the source."""
    place = (finding.file, finding.line, finding.column)
    try:
        content = Path(finding.file).read_bytes() if finding.line else b""
    except OSError:
        content = b""
    error = SdlError(finding.message, place, finding.hint, finding.stack)
    return format_error(error, {finding.file: decode(content)}, finding.severity)
