"""SDL: the expression that the tokens of a function's body make, where only what runs knows the tokens.

From the lowest: ``|``, ``&``, relations, ``+ -``, ``* /``, signs, ``.component``; nothing needs parentheses.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Final

from minipov.interpreter.errors import NotDeclaredError, Place, SdlError
from minipov.interpreter.functions import FLOAT_FUNCTIONS, component_number
from minipov.interpreter.items import Named, Punctuation, Word
from minipov.interpreter.runtime.evaluate import accumulate, captured, function_call
from minipov.interpreter.values import CONSTANT_WORDS, kind_of
from minipov.tracer.function import Expression, Operation, Parameter

_LEVELS: Final = ({"|"}, {"&"}, {"<", "<=", "=", "!=", ">=", ">"}, {"+", "-"}, {"*", "/"})


class FunctionParser:
    """Reads tokens; ``scope`` gives the number of each parameter, ``variable`` the value of a keyword."""

    def __init__(
        self, tokens: Sequence[Any], places: Sequence[Place], scope: dict[str, int], variable: Callable[[str], Any]
    ) -> None:
        self._tokens = tokens
        self._places = places
        self._scope = scope
        self._variable = variable
        self._at = 0

    def whole(self) -> Expression:
        """The expression that all tokens make.

        Raises:
            SdlError: they make none.
        """
        value = self._level(0)
        if self._at < len(self._tokens):
            self._refuse("an operator")
        return value

    # --- tokens ---

    @property
    def _next(self) -> Any:
        return self._tokens[self._at] if self._at < len(self._tokens) else None

    def _sign(self) -> str:
        token = self._next
        return token.text if isinstance(token, Punctuation) else ""

    def _skip(self, sign: str) -> None:
        if self._sign() != sign:
            self._refuse(f"'{sign}'")
        self._at += 1

    def _refuse(self, wanted: str) -> Any:
        token = self._next
        found = (
            "the end of the function" if token is None
            else f"'{token.text}'" if isinstance(token, Punctuation)
            else f"'{token.name}'" if isinstance(token, Word | Named)
            else kind_of(token)
        )  # fmt: skip
        raise SdlError(f"expected {wanted}, found {found}", self._places[min(self._at, len(self._places) - 1)])

    # --- expressions ---

    def _level(self, level: int) -> Expression:
        """Operands joined by the operators of a level; equal operators in a row make one operation."""
        if level == len(_LEVELS):
            return self._signed()
        value = self._level(level + 1)
        while (operator := self._sign()) in _LEVELS[level]:
            operands = [value]
            while self._sign() == operator:
                self._at += 1
                operands.append(self._level(level + 1))
            value = Operation(operator, tuple(operands))
        return value

    def _signed(self) -> Expression:
        sign = self._sign()
        if sign not in ("+", "-"):
            return self._primary()
        self._at += 1
        value = self._signed()
        return value if sign == "+" else Operation("neg", (value,))

    def _primary(self) -> Expression:
        token, place = self._next, self._places[self._at] if self._at < len(self._places) else None
        if self._sign() == "(":
            self._at += 1
            value = self._level(0)
            self._skip(")")
            return value
        if token is None or isinstance(token, Punctuation):
            self._refuse("a value")
        self._at += 1
        try:
            return self._operand(token)
        except SdlError as error:
            error.place = error.place if error.place[1] or place is None else place
            raise

    def _operand(self, token: Any) -> Expression:
        if isinstance(token, Word | Named) and token.name in self._scope:
            return Parameter(self._scope[token.name])
        if isinstance(token, Word) and self._sign() == "(":
            return self._builtin(token.name)
        if isinstance(token, Word):
            known = CONSTANT_WORDS.get(token.name)
            return captured(self._variable(token.name) if known is None else known)
        value = token.value if isinstance(token, Named) else token
        if value is None:
            raise NotDeclaredError(token.name)
        if self._sign() != "(":
            return captured(value)
        arguments = self._arguments()
        component = None
        if self._sign() == ".":
            self._at += 1
            word = self._next
            if not isinstance(word, Word | Named):
                self._refuse("a component")
            component = component_number(word.name)
            self._at += 1
        return function_call(value, arguments, component)

    def _arguments(self) -> tuple[Expression, ...]:
        self._skip("(")
        arguments: list[Expression] = []
        while self._sign() != ")":
            arguments.append(self._level(0))
            if self._sign() == ",":
                self._at += 1
        self._at += 1
        return tuple(arguments)

    def _builtin(self, name: str) -> Expression:
        if name == "sum" or name == "prod":
            return self._accumulated(name)
        counts = FLOAT_FUNCTIONS.get(name)
        if counts is None:
            raise SdlError(f"{name}() cannot stand in a function")
        arguments = self._arguments()
        if not counts[0] <= len(arguments) <= counts[1]:
            raise SdlError(f"{name}(): wrong number of arguments ({len(arguments)})")
        return Operation(name, arguments)

    def _accumulated(self, name: Any) -> Expression:
        self._skip("(")
        index = self._next
        if not isinstance(index, Word | Named):
            self._refuse("a name")
        self._at += 1
        outer, number = self._scope, max(self._scope.values(), default=-1) + 1
        self._skip(",")
        first = self._level(0)
        self._skip(",")
        last = self._level(0)
        self._skip(",")
        self._scope = {**outer, index.name: number}
        body = self._level(0)
        self._scope = outer
        self._skip(")")
        return accumulate(name, number, first, last, body)
