"""What to tell about a word: from the keyword table, the constructs, the comment above a declaration."""

from __future__ import annotations

from dataclasses import dataclass

from minipov.editor.analysis.document import Document
from minipov.editor.analysis.language import block, defaults
from minipov.editor.analysis.library import Library
from minipov.editor.analysis.names import Declaration
from minipov.editor.analysis.statements import STARTING
from minipov.editor.analysis.surroundings import path, surroundings
from minipov.editor.analysis.values import shown, value_of
from minipov.grammar.keywords import DIRECTIVES, KEYWORDS
from minipov.interpreter.registry import find
from minipov.interpreter.values import Vector

_LONGEST_SOURCE = 200


@dataclass(frozen=True, slots=True)
class Help:
    """``code`` is SDL, ``text`` plain words; the word stands at ``start`` to ``end``."""

    start: int
    end: int
    code: str
    text: str


def help_at(document: Document, library: Library, offset: int) -> Help | None:
    """What to tell about the word at an offset."""
    found = document.token_at(offset)
    if found is None:
        return None
    token, start = found
    begin, end = start + (token.start_pos or 0), start + (token.end_pos or 0)
    word = str(token.value)
    if token.type == "NAME":
        known = library.lookup(document, word, begin)
        return known and Help(begin, end, *about_declaration(library, *known))
    _, statement = document.at(begin)
    if token.type == "STRING":
        before = statement.tokens[: statement.tokens.index(token)]
        file = library.find(word, document) if before and before[-1].type == "INCLUDE" else None
        return Help(begin, end, f'#include "{word}"', str(file)) if file else None
    directive = word.lstrip("# \t\r\n")
    if word.startswith("#") and directive in DIRECTIVES:
        return Help(begin, end, *DIRECTIVES[directive])
    for other, stack in surroundings(statement.tokens):
        if other is token and word in KEYWORDS and token.type not in STARTING:
            code, text = about_keyword(word, path(stack))
            return Help(begin, end, code, text)
    return None


def about_keyword(word: str, blocks: tuple[str, ...]) -> tuple[str, str]:
    """Signature and meaning of a keyword inside blocks, the outermost first."""
    entry = KEYWORDS[word]
    construct = find(word, blocks[-1] if blocks else "")
    lines = []
    if construct is not None:
        code = f"{word} {{ {construct.signature.strip('{} ')} }}"
        lines.append(construct.doc)
    else:
        code = entry.signature or word
        lines.append(entry.doc[:1].upper() + entry.doc[1:] + ".")
    around = block(blocks) if blocks else None
    default = defaults(around).get(word) if around else None
    if default is not None and around is not None:
        lines.append(f"Default in {around.name}: {_shown_default(default)}")
    if entry.since > 3.7:
        lines.append(f"Since version {entry.since:g}; an identifier before.")
    return code, "\n\n".join(lines)


def about_declaration(library: Library, document: Document, declaration: Declaration) -> tuple[str, str]:
    """Source and meaning of a declared name."""
    lines = []
    value = value_of(library, document, declaration)
    code = heading(document, declaration)
    if value is not None and shown(value) != code.partition("=")[2].strip(" ;"):
        lines.append(f"= {shown(value)}")
    if declaration.comment:
        lines.append(declaration.comment)
    lines.append(f"Declared in {document.path.rpartition('/')[2] or 'this text'}, "
                 f"line {document.line_of(declaration.start) + 1}.")  # fmt: skip
    return code, "\n\n".join(lines)


def heading(document: Document, declaration: Declaration) -> str:
    """A declaration in short."""
    if declaration.kind == "macro":
        return f"#macro {declaration.name}({', '.join(declaration.parameters)})"
    if declaration.kind == "parameter":
        return f"{declaration.name} (parameter)"
    source = " ".join(document.text[declaration.from_ : declaration.to].split())
    if len(source) > _LONGEST_SOURCE:
        source = source[:_LONGEST_SOURCE].rsplit(" ", 1)[0] + " ..."
    return source


def _shown_default(value: object) -> str:
    if isinstance(value, bool):
        return "on" if value else "off"
    if isinstance(value, tuple):
        return shown(Vector(float(term or 0) for term in value))
    return shown(value) if isinstance(value, float | str) else str(value)
