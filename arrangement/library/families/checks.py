"""The check of size that all families share."""

from __future__ import annotations

import math

from arrangement.numbers import budget


def planned(planes: float, dimension: float, bits: float = 0) -> None:
    """Refuse a member that is out of reach, before any plane of it is made.

    Args:
        bits: of an entry, where they are many.
    """
    entries = planes * dimension if math.inf not in (planes, dimension) else math.inf
    budget.check_cost(
        f"{budget.about(planes)} planes in dimension {budget.about(dimension)}",
        "take a smaller member",
        steps=60 * planes + entries * (2 + bits**2 / 10_000 if bits < 1e100 else math.inf),
        bytes=350 * planes + entries * (90 + bits / 8),
    )
