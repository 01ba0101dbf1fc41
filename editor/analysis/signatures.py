"""The parameters of the macro or function that is being called."""

from __future__ import annotations

from dataclasses import dataclass

from minipov.editor.analysis.context import call_at
from minipov.editor.analysis.document import Document
from minipov.editor.analysis.library import Library
from minipov.grammar.keywords import KEYWORDS


@dataclass(frozen=True, slots=True)
class Signature:
    """A call as it should be written; ``argument`` is the one being typed, from 0."""

    text: str
    parameters: tuple[str, ...]
    argument: int
    comment: str = ""


def signature_at(document: Document, library: Library, offset: int) -> Signature | None:
    """The signature of the innermost call around an offset."""
    call = call_at(document, offset)
    if call is None:
        return None
    keyword = KEYWORDS.get(call.name)
    if keyword is not None:
        if "(" not in keyword.signature:
            return None
        parameters = keyword.signature.partition("(")[2].rstrip(")").split(", ")
        return _signature(call.name, tuple(parameters), call.argument, keyword.doc)
    found = library.lookup(document, call.name, call.start)
    if found is None or found[1].kind not in {"macro", "function"}:
        return None
    _, declaration = found
    parameters = list(declaration.parameters)
    if declaration.kind == "function" and not parameters:
        parameters = ["x", "y", "z"]
    return _signature(call.name, tuple(parameters), call.argument, declaration.comment)


def _signature(name: str, parameters: tuple[str, ...], argument: int, comment: str) -> Signature:
    last = len(parameters) - 1
    if parameters and parameters[-1] == "...":
        argument = min(argument, last)
    return Signature(f"{name}({', '.join(parameters)})", parameters, argument, comment)
