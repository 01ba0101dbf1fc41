"""Going on after a mistake, to find the others: what is wrong with a scene, statement by statement."""

from __future__ import annotations

from typing import Final

from minipov.interpreter.errors import HaltedError, NotDeclaredError, SdlError
from minipov.interpreter.runtime.faults import explained
from minipov.interpreter.runtime.program import Running

_MOST: Final = 20


class Recovery:
    """Collects the mistakes of a run. A name whose declaration failed is not complained of again where it is used."""

    def __init__(self, running: Running, main: str, problems: list[SdlError]) -> None:
        self.problems = problems
        self._running = running
        self._main = main
        self._lost: set[str] = set()

    def recovered(self, raised: Exception, declared: str | None) -> None:
        """Take note of what a statement raised, which would have declared a name.

        Raises:
            SdlError: what comes after this mistake makes no sense without it, or there are too many.
        """
        error = explained(raised, self._running.sources)
        if declared is not None:
            self._lost.add(declared)
        known = isinstance(error, NotDeclaredError) and error.name in self._lost
        if isinstance(error, NotDeclaredError):
            self._lost.add(error.name)
        self._running.blocks.abandon()
        if known:
            return
        hopeless = isinstance(raised, RecursionError | MemoryError | HaltedError)
        if hopeless or error.place[0] != self._main or len(self.problems) + 1 >= _MOST:
            raise error
        self.problems.append(error)
