"""Parsing that goes on after a mistake, with Lark's interactive parser.

At an unexpected token the parser is first given what is missing, if that makes the token fit (``sphere { <0, 0 }``
lacks a ``>``); failing that, the token is left out.
"""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from typing import Any, Final

from lark import Token
from lark.exceptions import UnexpectedToken
from lark.parsers.lalr_interactive_parser import InteractiveParser
from minipov.editor.analysis.problem import Problem
from minipov.editor.analysis.statements import Statement
from minipov.grammar.errors import SdlSyntaxError
from minipov.grammar.explain import explain
from minipov.grammar.parser import interactive_parser

_MOST_PROBLEMS: Final = 20
_DEEPEST: Final = 4
_SUSPECT: Final = 4
"""How many tokens must fit, after one that did not, until mistakes are believed again."""

_MISSING: Final = {
    "NUMBER": "0", "MORE": ">", "RPAR": ")", "RSQB": "]", "NAME": "missing", "EQUAL": "=", "LPAR": "(", "RBRACE": "}",
    "END": "#end",
}  # fmt: skip
"""What may be put in, the likeliest first."""

_CLOSES_BODIES: Final = {"RBRACE": {"END", "$END"}, "END": {"$END"}}
"""What closes a whole block or directive is put in only before these."""


def parse(statement: Statement) -> tuple[tuple[Any, ...], list[Problem]]:
    """The items of a statement's tree as far as there are any, and what is wrong in it."""
    last = statement.tokens[-1] if statement.tokens else Token("NAME", "", 0, 1, 1)
    return parse_tokens(statement.marked(), last, statement)


def parse_tokens(tokens: Sequence[Token], last: Token, statement: Statement) -> tuple[tuple[Any, ...], list[Problem]]:
    """The same for some of the tokens of a statement, of which ``last`` tells where they end.

    What follows a token left out is likely a consequence and not reported.
    """
    parser = interactive_parser()
    problems: list[Problem] = []
    quiet = 0
    result: Any = None
    try:
        for token in (*tokens, Token.new_borrow_pos("$END", "", last)):
            try:
                result = parser.feed_token(token)
                quiet -= 1
            except UnexpectedToken as error:
                if quiet <= 0 and not _is_echo(problems, error):
                    problems.append(_problem(error, statement))
                missing = _what_is_missing(parser, token)
                for kind in missing:
                    parser.feed_token(_inserted(kind, token))
                if missing:
                    result = parser.feed_token(token)
                else:
                    quiet = _SUSPECT
                if len(problems) >= _MOST_PROBLEMS:
                    break
    except SdlSyntaxError as error:
        problems.append(_placed(error, statement))
    items = result if isinstance(result, tuple) else ()
    return items, problems


def _is_echo(problems: list[Problem], error: UnexpectedToken) -> bool:
    """Whether only a closing bracket is amiss, after another mistake in the same statement."""
    return bool(problems) and error.token.type in {"RPAR", "RBRACE", "RSQB", "MORE", "END", "$END"}


def _what_is_missing(parser: InteractiveParser, token: Token) -> Sequence[str]:
    """The shortest run of tokens after which the parser takes ``token``; empty if there is none."""
    trials: list[tuple[InteractiveParser, tuple[str, ...]]] = [(_trial(parser), ())]
    for _ in range(_DEEPEST):
        longer = []
        for state, given in trials:
            accepted = state.accepts()  # type: ignore[no-untyped-call]  # Lark has no type for it
            for kind in _MISSING:
                if kind not in accepted or token.type not in _CLOSES_BODIES.get(kind, {token.type}):
                    continue
                if given and (kind == "LPAR" or (kind in given and kind in {"NUMBER", "NAME"})):
                    continue
                further = _trial(state)
                further.feed_token(_inserted(kind, token))
                if _takes(further, token):
                    return (*given, kind)
                longer.append((further, (*given, kind)))
        trials = longer[:24]
    return ()


def _takes(state: InteractiveParser, token: Token) -> bool:
    try:
        _trial(state).feed_token(token)
    except UnexpectedToken:
        return False
    return True


def _trial(parser: InteractiveParser) -> InteractiveParser:
    """A copy of the parser that builds nothing."""
    trial: InteractiveParser = parser.copy(deepcopy_values=False)  # type: ignore[no-untyped-call]  # nor for it
    trial.parser_state.parse_conf = copy(trial.parser_state.parse_conf)
    trial.parser_state.parse_conf.callbacks = _Nothing()
    return trial


class _Nothing(dict[Any, Any]):
    def __missing__(self, rule: Any) -> Any:
        return lambda children: None


def _inserted(kind: str, before: Token) -> Token:
    return Token.new_borrow_pos(kind, _MISSING[kind], before)


def _problem(error: UnexpectedToken, statement: Statement) -> Problem:
    explained = explain(error, statement.text, "")
    if error.token.type == "$END" and not explained.hint:
        explained.message = "this statement is not finished"
    return _placed(explained, statement)


def _placed(error: SdlSyntaxError, statement: Statement) -> Problem:
    """The error at the token where it was found."""
    token = _token_at(statement, error.line, error.column)
    if token is None:
        end = len(statement.text.rstrip())
        return Problem(max(0, end - 1), max(1, end), error.message, error.hint)
    opener = _token_at(statement, *error.opened) if error.opened else None
    if opener is None:
        return Problem(token.start_pos or 0, token.end_pos or 0, error.message, error.hint)
    return Problem(token.start_pos or 0, token.end_pos or 0, error.message, opened=opener.start_pos)


def _token_at(statement: Statement, line: int, column: int) -> Token | None:
    return next((token for token in statement.tokens if token.line == line and token.column == column), None)
