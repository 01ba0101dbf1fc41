"""Animation: which frames to render, and the clock of each.

INI: ``Initial_Frame=1 Final_Frame=10 Initial_Clock=0 Final_Clock=1``, switches ``+KFI1 +KFF10 +KI0 +KF1 +SF +EF +KC``.
"""

from __future__ import annotations

from dataclasses import dataclass

from minipov.options import CommandLine


@dataclass(frozen=True, slots=True)
class Frame:
    """One picture; the fields are SDL's variables of the same name. ``suffix`` goes into the name of its file."""

    clock: float = 0.0
    clock_on: bool = False
    clock_delta: float = 0.0
    frame_number: int = 0
    initial_frame: int = 0
    final_frame: int = 0
    initial_clock: float = 0.0
    final_clock: float = 0.0
    suffix: str = ""


def frames(command: CommandLine) -> list[Frame]:
    """Return the frames to render, in order: one without animation."""
    if "Final_Frame" not in command.given:
        return [Frame(command.number("Clock"), clock_on="Clock" in command.given)]
    first = command.integer("Initial_Frame")
    last = max(command.integer("Final_Frame"), first)
    # A cyclic animation would show its first picture again one frame after the last.
    end = last + 1 if command.flag("Cyclic_Animation") else last
    start_clock, end_clock = command.number("Initial_Clock"), command.number("Final_Clock")
    delta = (end_clock - start_clock) / (end - first) if end > first else 0.0
    subset = range(
        _subset(command, "Subset_Start_Frame", first, last),
        _subset(command, "Subset_End_Frame", last, last) + 1,
        max(command.integer("Frame_Step"), 1),
    )
    return [
        Frame(
            clock=start_clock + delta * (number - first),
            clock_on=True,
            clock_delta=delta,
            frame_number=number,
            initial_frame=first,
            final_frame=end,
            initial_clock=start_clock,
            final_clock=end_clock,
            suffix=str(number).zfill(len(str(last))),
        )
        for number in subset
        if first <= number <= last
    ]


def _subset(command: CommandLine, key: str, default: int, last: int) -> int:
    """A frame number, or a share of the last one."""
    if key not in command.given:
        return default
    value = command.values[key]
    return int(value * last) if isinstance(value, float) and value <= 1 else int(value)
