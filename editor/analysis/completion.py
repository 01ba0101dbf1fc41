"""What may be typed at an offset."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal, TypeAlias

from minipov.editor.analysis.context import Context, context_at
from minipov.editor.analysis.document import Document
from minipov.editor.analysis.help import about_keyword, heading
from minipov.editor.analysis.language import BLOCKS, MEMBERS, accepted, block, defaults, is_callable, takes_color
from minipov.editor.analysis.library import Library
from minipov.editor.analysis.names import Declaration, locals_at
from minipov.grammar.keywords import DIRECTIVES, KEYWORDS, Kind

CompletionKind: TypeAlias = Literal["block", "keyword", "function", "constant", "name", "macro", "file", "member"]


@dataclass(frozen=True, slots=True)
class Completion:
    """A word that fits; it replaces the text from ``start`` on. Those of lower ``rank`` come first."""

    word: str
    kind: CompletionKind
    start: int
    detail: str = ""
    rank: int = 1
    insert: str | None = None


def completions(document: Document, library: Library, offset: int) -> list[Completion]:
    """All words that fit at an offset; the editor keeps those that go with what is typed."""
    context = context_at(document, offset)
    match context.situation:
        case "comment" | "string" | "name":
            return []
        case "include":
            files = library.files_for(context.typed, document)
            return [Completion(file, "file", context.start) for file in files]
        case "directive":
            return [Completion(word, "keyword", context.start, form) for word, (form, _) in DIRECTIVES.items()]
        case "member":
            return [Completion(word, "member", context.start) for word in MEMBERS]
    found = [*_names(document, library, context, offset)]
    if context.situation == "value":
        return [*found, *_values(context)]
    return [*_items(context), *found, *_values(context)]


def _items(context: Context) -> Iterator[Completion]:
    """Keywords that the open block accepts."""
    around = block(context.blocks) if context.blocks else None
    unsaid = defaults(around) if around else {}
    for word in sorted(accepted(context.blocks)):
        if word in KEYWORDS and (word in BLOCKS or not context.blocks or context.blocks[-1]):
            code, text = about_keyword(word, context.blocks)
            is_block = word in BLOCKS and word not in unsaid
            insert = f"{word} {{ $0 }}" if is_block else None
            detail = code if is_block else text.splitlines()[0]
            yield Completion(word, "block" if is_block else "keyword", context.start, detail, 0, insert)


def _values(context: Context) -> Iterator[Completion]:
    """Functions and constants; colours where one may stand."""
    colors = takes_color(context.blocks) if context.blocks else True
    for keyword in KEYWORDS.values():
        if is_callable(keyword.name):
            yield Completion(keyword.name, "function", context.start, keyword.signature, 2, f"{keyword.name}($0)")
        elif keyword.kind is Kind.CONSTANT:
            yield Completion(keyword.name, "constant", context.start, keyword.doc, 2)
        elif keyword.kind is Kind.RGB and context.situation == "value" and colors:
            yield Completion(keyword.name, "keyword", context.start, keyword.signature, 2)
    if context.situation == "value" and not context.openings:
        for word in sorted(BLOCKS - {"#default"}):
            yield Completion(word, "block", context.start, about_keyword(word, ())[0], 2, f"{word} {{ $0 }}")


def _names(document: Document, library: Library, context: Context, offset: int) -> Iterator[Completion]:
    known: set[str] = set()
    for declaration in locals_at(document, offset):
        known.add(declaration.name)
        yield _name(document, declaration, context, 0)
    for other, declaration in library.declared(document):
        if declaration.name not in known and declaration.start != context.start:
            known.add(declaration.name)
            yield _name(other, declaration, context, 1)


def _name(document: Document, declaration: Declaration, context: Context, rank: int) -> Completion:
    is_call = declaration.kind in {"macro", "function"}
    insert = f"{declaration.name}($0)" if is_call else None
    kind: CompletionKind = "macro" if is_call else "name"
    return Completion(declaration.name, kind, context.start, heading(document, declaration), rank, insert)
