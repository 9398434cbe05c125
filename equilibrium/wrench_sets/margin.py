"""How far a wrench is from the boundary of what is resisted, and which preloads resist it.

Both questions are intervals along one direction. For the preload this is so because the equations
are homogeneous in motion, forces, wrench and preload together: a grasp whose preloads are p times
those of another resists w exactly when the other one resists w / p.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from arrangement.exact import RationalVector
from arrangement.polyhedra.intervals import Interval, end_text, holds, texts, union
from arrangement.short_repr import Shown
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.verdict import Solver, prepare, solve

from .line import resisted_magnitudes

_ALL: Interval = (Fraction(0), None)


@dataclass(frozen=True, repr=False)
class Margin(Shown):
    """How a wrench may be scaled.

    Attributes:
        resisted: whether the wrench itself is resisted.
        intervals: all s >= 0 with s times the wrench resisted, disjoint, closed, increasing.
    """

    wrench: RationalVector
    resisted: bool
    intervals: tuple[Interval, ...]

    def __bool__(self) -> bool:
        """Return whether the wrench itself is resisted."""
        return self.resisted

    @property
    def around(self) -> Interval | None:
        """The interval of factors around 1, its ends on the boundary; None if not resisted.

        Its upper end is the largest s with t times the wrench resisted for all t in [1, s]; None
        there means that no factor is too large.
        """
        return next((part for part in self.intervals if holds([part], Fraction(1))), None)

    @property
    def nearest(self) -> Fraction | None:
        """Of a wrench that is not resisted: the factor of a resisted one nearest to 1, if any."""
        ends = [end for part in self.intervals for end in part if end is not None]
        if self.resisted:
            return Fraction(1)
        return min(ends, key=lambda end: abs(end - 1), default=None)

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form; numbers are strings, null means no end (or none)."""
        return {
            "resisted": self.resisted,
            "around": None if self.around is None else texts(self.around),
            "nearest": end_text(self.nearest),
            "intervals": list(map(texts, self.intervals)),
        }


def margin(grasp: Grasp | Solver, wrench: Iterable[Any]) -> Margin:
    """Return the exact factors by which a wrench may be scaled.

    >>> from equilibrium.io.files import read_grasp
    >>> margin(read_grasp("paper-three-contacts-preload-1"), [0, "1/2", 0]).around
    (Fraction(0, 1), Fraction(2, 1))
    """
    w = read_wrench(wrench)
    solver = prepare(grasp)
    if any(w):
        found = resisted_magnitudes(solver, w).intervals
    else:
        found = (_ALL,) if solver.solve(w).stable else ()
    return Margin(w, holds(found, Fraction(1)), found)


@dataclass(frozen=True)
class Preloads:
    """All p >= 0 for which a grasp resists a wrench when every preload is p.

    Attributes:
        intervals: disjoint, closed, increasing; an upper end None means no end.
    """

    wrench: RationalVector
    intervals: tuple[Interval, ...]

    @property
    def least(self) -> Fraction | None:
        """The least uniform preload; None when none is enough."""
        return self.intervals[0][0] if self.intervals else None

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form; numbers are strings, null means no end (or none)."""
        return {
            "least": end_text(self.least),
            "intervals": list(map(texts, self.intervals)),
        }


def sufficient_preloads(grasp: Grasp, wrench: Iterable[Any]) -> Preloads:
    """Return all uniform preloads with which a grasp resists a wrench, exactly.

    The preloads of the grasp itself are replaced. A larger preload is not always better, so the
    whole set is returned; its least element is `Preloads.least`.

    >>> from equilibrium.io.files import read_grasp
    >>> sufficient_preloads(read_grasp("paper-three-contacts"), [0, 3, 0]).least
    Fraction(3, 1)
    """
    w = read_wrench(wrench)
    unloaded = solve(grasp.with_preload(0), w).stable
    parts: list[Interval] = [(Fraction(0), Fraction(0))] if unloaded else []
    loaded = Solver(grasp.with_preload(1))
    if any(w):
        factors = resisted_magnitudes(loaded, w).intervals
        parts += [_reciprocal(part) for part in factors if part[1] != 0]
    elif loaded.solve(w).stable:
        parts.append(_ALL)
    return Preloads(w, union(parts))


def _reciprocal(factors: Interval) -> Interval:
    """Return the preloads ``1 / s`` of factors s > 0.

    Without an upper end the wrench is a direction in which the piece never ends, and then no
    preload at all is enough too: the end 0 belongs.
    """
    low, high = factors
    return (Fraction(0) if high is None else 1 / high, 1 / low if low else None)
