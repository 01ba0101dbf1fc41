"""What is probably wrong in a text that can be parsed: unknown names, files that are not there, words out of place."""

from __future__ import annotations

from collections.abc import Iterator
from difflib import get_close_matches
from typing import Final

from lark import Token
from minipov.editor.analysis.document import Document
from minipov.editor.analysis.language import BLOCKS, accepted, homes, is_color_word, is_pattern_list
from minipov.editor.analysis.library import Library
from minipov.editor.analysis.names import includes, local_at, names_in
from minipov.editor.analysis.problem import Problem
from minipov.editor.analysis.statements import Statement
from minipov.editor.analysis.surroundings import path, surroundings
from minipov.editor.analysis.syntax import syntax_problems
from minipov.grammar.keywords import KEYWORDS

_MOST_UNKNOWN: Final = 50
_ASKING: Final = frozenset({"IFDEF", "IFNDEF"})


def problems(document: Document, library: Library) -> list[Problem]:
    """All that is wrong, from top to bottom."""
    found = [
        *syntax_problems(document),
        *_missing_files(document, library),
        *_words_out_of_place(document),
        *_unknown_names(document, library),
    ]
    return sorted(found, key=lambda problem: problem.start)


def _missing_files(document: Document, library: Library) -> Iterator[Problem]:
    """Included files that are not there, but for those that the scene itself writes."""
    for include in includes(document):
        if library.find(include.file, document) is None and include.file not in document.known("written", _written):
            close = get_close_matches(include.file, library.files_for("", document), 1)
            hint = f"did you mean '{close[0]}'?" if close else None
            yield Problem(include.start, include.end, f"cannot find '{include.file}'", hint, certain=False)


def _written(document: Document) -> set[str]:
    return {
        str(file.value)
        for statement in document.statements
        for before, file in zip(statement.tokens, statement.tokens[2:], strict=False)
        if before.type == "FOPEN" and file.type == "STRING"
    }


def _words_out_of_place(document: Document) -> Iterator[Problem]:
    for start, statement in document.placed():
        for problem in statement.known("misplaced", lambda statement: list(_misplaced(statement))):
            yield problem.moved(start)


def _misplaced(statement: Statement) -> Iterator[Problem]:
    """Keywords directly in a block that does not take them."""
    for token, stack in surroundings(statement.tokens):
        if token.type != "WORD" or not stack or stack[-1].mark != "{" or is_color_word(token.value):
            continue
        blocks = path(stack)
        words = accepted(blocks)
        if not words or token.value in words or is_pattern_list(blocks):
            continue
        close = get_close_matches(token.value, words, 1)
        places = homes(token.value)
        hint = None
        if places:
            hint = f"it may stand in {', '.join(places[:4])}"
        elif close:
            hint = f"did you mean '{close[0]}'?"
        yield _at(token, f"'{token.value}' may not stand in {blocks[-1]}", hint)


def _unknown_names(document: Document, library: Library) -> list[Problem]:
    """Names that neither the text nor what it includes declares.

    An include file may rely on names of the scene that includes it, so only scenes are looked at.
    """
    if not document.path.lower().endswith(".pov"):
        return []
    chain = library.chain(document)
    if not library.is_complete(chain):
        return []
    known = {declaration.name for _, declaration in library.declared(document)}
    for one in chain:
        known |= one.known("asked", _asked_about)
    found: list[Problem] = []
    for start, statement in document.placed():
        for token in names_in(statement).used:
            if token.value in known or len(found) == _MOST_UNKNOWN:
                continue
            if local_at(document, token.value, start + (token.start_pos or 0)) is None:
                found.append(_unknown(token, statement, known).moved(start))
    return found


def _unknown(token: Token, statement: Statement, known: set[str]) -> Problem:
    is_block = statement.text[token.end_pos :].lstrip().startswith("{")
    close = get_close_matches(token.value, BLOCKS if is_block else known | KEYWORDS.keys(), 1)
    hint = f"did you mean '{close[0]}'?" if close else None
    what = "block" if is_block else "name"
    return _at(token, f"unknown {what} '{token.value}'", hint)


def _asked_about(document: Document) -> set[str]:
    """The names that the text asks for with ``#ifdef``: the command line may declare them."""
    asked = set()
    for statement in document.statements:
        asked |= statement.known("asked", _asked_in)
    return asked


def _asked_in(statement: Statement) -> set[str]:
    return {
        str(token.value)
        for before, token in zip(statement.tokens, statement.tokens[2:], strict=False)
        if before.type in _ASKING or before.value == "defined"
    }


def _at(token: Token, message: str, hint: str | None) -> Problem:
    return Problem(token.start_pos or 0, token.end_pos or 0, message, hint, certain=False)
