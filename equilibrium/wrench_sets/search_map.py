"""The paper's map of resisted forces: a binary search in each of N directions, approximate.

The search assumes that a direction is resisted up to one magnitude and never beyond. Where the
exact set is not one interval that starts at 0, its answer is wrong by more than the tolerance: it
may stop below a part that is resisted, or pass over a gap. Each entry of the map says so.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from math import cos, pi, sin
from typing import Any

from arrangement.console.number_form import JsonMixin
from arrangement.console.progress import watched
from arrangement.numbers.exact import RationalVector, rational, shown, to_text
from arrangement.numbers.linear.intervals import Interval, holds, intersection, remainder, union
from equilibrium.decide.solver import Solver
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.model.unit_normal import unit_normal

from .slice import resisted_region

#: Of the largest magnitude and the tolerance: a search halves the one until it is below the other.
MAX_RATIO = 2**200


@dataclass(frozen=True)
class Entry(JsonMixin):
    """One direction of the map.

    Attributes:
        direction: exactly unit, rational, in plane coordinates.
        found: what the binary search says is the largest resisted magnitude, within the tolerance;
            None when the largest magnitude tried is resisted ("unbounded").
        exact: the resisted magnitudes, disjoint closed intervals.
        wrongly_claimed: magnitudes up to the answer that are not resisted (closures of gaps).
        missed: resisted magnitudes above the answer by more than the tolerance, up to the limit.
    """

    json_fields = ("direction", "found", "agrees", "exact", "wrongly_claimed", "missed")

    direction: RationalVector
    found: Fraction | None
    exact: tuple[Interval, ...]
    wrongly_claimed: tuple[Interval, ...]
    missed: tuple[Interval, ...]

    @property
    def agrees(self) -> bool:
        """Whether the answer of the search is right within the tolerance, up to the limit."""
        return not self.wrongly_claimed and not self.missed


@dataclass(frozen=True)
class SearchMap:
    """The map, with the tolerance and the largest magnitude of its searches."""

    tolerance: Fraction
    limit: Fraction
    entries: tuple[Entry, ...]

    @property
    def disagreements(self) -> tuple[Entry, ...]:
        """The directions in which the search is wrong."""
        return tuple(entry for entry in self.entries if not entry.agrees)

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form; numbers are strings of rationals."""
        return {
            "tolerance": to_text(self.tolerance),
            "limit": to_text(self.limit),
            "entries": [entry.to_dict() for entry in self.entries],
            "disagreements": len(self.disagreements),
        }


def search_map(
    grasp: Grasp | Solver,
    rays: int = 72,
    tolerance: Any = Fraction(1, 1000),
    max_magnitude: Any = 1000,
) -> SearchMap:
    """Return the map by binary search, in directions from the x axis on: `ResistedSet.search`.

    Directions are exactly unit rational vectors within 10^-6 (radians) of evenly spaced ones, so
    every verdict in the search is about an exact wrench.

    Source: [HaasHeger2018], Section VI, the maps of resisted forces.
    """
    step, largest = rational(tolerance, "tolerance"), rational(max_magnitude, "max_magnitude")
    if rays < 1 or step <= 0 or largest <= 0:
        raise GraspError(
            f"rays {shown(rays)}, tolerance {shown(step)}, max_magnitude {shown(largest)}: "
            "all must be above 0"
        )
    if largest > step * MAX_RATIO:
        raise GraspError(
            f"tolerance is {shown(step)}; expected at least 2^-{MAX_RATIO.bit_length() - 1} of "
            f"max_magnitude, which is {shown(largest)}"
        )
    region = resisted_region(grasp)
    entries = []
    for i in watched(range(rays), "directions"):
        angle = 2 * pi * i / rays
        direction = unit_normal([cos(angle), sin(angle)]).normal
        entries.append(compare(direction, region.along(direction), step, largest))
    return SearchMap(step, largest, tuple(entries))


def compare(
    direction: RationalVector, exact: tuple[Interval, ...], tolerance: Fraction, limit: Fraction
) -> Entry:
    """Run the binary search with exact verdicts, and set its answer beside the exact set."""
    largest = binary_search(exact, tolerance, limit)
    answer = limit if largest is None else largest
    claimed = (Fraction(0), answer)
    wrong = remainder(claimed, exact)
    beyond = (min(answer + tolerance, limit), limit)
    missed = [] if largest is None else [intersection(part, beyond) for part in exact]
    kept = (part for part in missed if part is not None and part[1] != beyond[0])
    return Entry(direction, largest, exact, wrong, union(kept))


def binary_search(
    resisted: Iterable[Interval], tolerance: Fraction, limit: Fraction
) -> Fraction | None:
    """Return the paper's answer; None when the limit itself is resisted.

    The interval [low, high] keeps low resisted (or 0, without asking) and high not resisted.
    """
    parts = tuple(resisted)
    if holds(parts, limit):
        return None
    low, high = Fraction(0), limit
    while high - low > tolerance:
        middle = (low + high) / 2
        if holds(parts, middle):
            low = middle
        else:
            high = middle
    return low
