"""The classes a compared picture falls into, from best to worst."""

from __future__ import annotations

from typing import Literal, TypeAlias

from minipov.compare.metrics import Metrics

Verdict: TypeAlias = Literal["exact", "close", "off", "failed", "no reference"]

VERDICTS: dict[Verdict, str] = {
    "exact": "at least 99 % of the pixels within 2/255, FLIP at most 0.01",
    "close": "FLIP at most 0.05: right but for the noise of sampling",
    "off": "a picture, further away",
    "failed": "no picture",
    "no reference": "POV-Ray makes no picture either",
}
EXACT_WITHIN2, EXACT_FLIP, CLOSE_FLIP = 0.99, 0.01, 0.05


def judge(metrics: Metrics) -> Verdict:
    """Return the class of a measured pair."""
    if metrics.within2 >= EXACT_WITHIN2 and metrics.flip <= EXACT_FLIP:
        return "exact"
    return "close" if metrics.flip <= CLOSE_FLIP else "off"


def is_within(verdict: Verdict, tolerance: Verdict) -> bool:
    """Whether ``verdict`` is as good as ``tolerance`` or better."""
    order = list(VERDICTS)
    return order.index(verdict) <= order.index(tolerance)
