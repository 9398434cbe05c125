"""Which magnitudes along a direction a grasp in space resists: brackets of the ends, both proved.

The set of resisted magnitudes need not be an interval, and in space its ends are algebraic numbers
of no small degree. So verdicts are asked for at sampled magnitudes, and where they change the
change is enclosed by bisection between two proofs. What lies between samples of the same verdict is
not looked at.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any

from arrangement.exact import RationalVector, to_text
from equilibrium.inputs.conversion import simplest_between
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.spatial_verdict import NOT_RESISTED, RESISTED, UNDECIDED, solve_in_space

#: Powers of two of the sampled magnitudes, times the largest preload or 1.
_POWERS = range(-6, 9)
#: Bisection steps without progress because verdicts are undecided.
_STUCK = 2
#: A bracket this many times narrower than its relative width at the samples is left as it is.
_FLOOR = 10**6
#: Of the tree of a verdict.
_NODES = 400


@dataclass(frozen=True)
class Border:
    """A change of the verdict between two magnitudes.

    Attributes:
        resisted, refused: the two magnitudes, both proved; either may be the larger one.
        undecided: magnitudes between them that were tried and left open.
    """

    resisted: Fraction
    refused: Fraction
    undecided: tuple[Fraction, ...] = ()

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        return {
            "resisted": to_text(self.resisted),
            "not_resisted": to_text(self.refused),
            "undecided": list(map(to_text, self.undecided)),
        }


@dataclass(frozen=True)
class SpatialMagnitudes:
    """What is known of the magnitudes t >= 0 with ``base + t direction`` resisted.

    Attributes:
        samples: magnitudes and their verdicts, increasing.
        borders: each change of the verdict between neighbouring samples that are decided.
    """

    direction: RationalVector
    base: RationalVector
    samples: tuple[tuple[Fraction, str], ...]
    borders: tuple[Border, ...]

    @property
    def verdict(self) -> str:
        """Whether any sample is resisted; "undecided" if none is and some are open."""
        verdicts = {verdict for _, verdict in self.samples}
        if RESISTED in verdicts:
            return RESISTED
        return UNDECIDED if UNDECIDED in verdicts else NOT_RESISTED

    @property
    def gaps(self) -> tuple[tuple[Border, Border], ...]:
        """Neighbouring borders between which the wrench is not resisted, though it is beyond."""
        pairs = pairwise(self.borders)
        return tuple((a, b) for a, b in pairs if a.resisted < a.refused and b.refused < b.resisted)

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form; numbers are strings of rationals."""
        return {
            "direction": list(map(to_text, self.direction)),
            "base": list(map(to_text, self.base)),
            "verdict": self.verdict,
            "borders": [border.to_dict() for border in self.borders],
            "samples": [{"t": to_text(t), "verdict": verdict} for t, verdict in self.samples],
        }


def spatial_magnitudes(
    grasp: Grasp,
    direction: Iterable[Any],
    base: Iterable[Any] = (0,) * 6,
    *,
    width: Any = Fraction(1, 10**6),
    nodes: int = _NODES,
) -> SpatialMagnitudes:
    """Bracket the magnitudes that a grasp in space resists along a direction.

    Args:
        width: of a bracket, relative to its larger end; where the verdict changes at 0, a millionth
            of this share of the sample beyond.
        nodes: of the tree of each verdict, at most.

    Raises:
        GraspError: the direction is zero.

    >>> from equilibrium.io.files import read_grasp
    >>> fingers = read_grasp("two-opposed-fingers")
    >>> spatial_magnitudes(fingers, [0, 1, 0, 0, 0, 0]).borders[0].resisted
    Fraction(1, 1)
    """
    along, start = (read_wrench(w, grasp.dimension) for w in (direction, base))
    if not any(along):
        raise GraspError("the direction is zero; give one that is not")

    def verdict(t: Fraction) -> str:
        wrench = [b + t * x for b, x in zip(start, along, strict=True)]
        return solve_in_space(grasp, wrench, nodes=nodes).verdict

    unit = max((c.preload for c in grasp), default=Fraction(0)) or Fraction(1)
    samples = [(t, verdict(t)) for t in (Fraction(0), *(unit * Fraction(2) ** k for k in _POWERS))]
    known = [(t, answer) for t, answer in samples if answer != UNDECIDED]
    borders = tuple(
        _bracket(verdict, first, second, Fraction(width))
        for first, second in pairwise(known)
        if first[1] != second[1]
    )
    return SpatialMagnitudes(along, start, tuple(samples), borders)


def _bracket(
    verdict: Any, first: tuple[Fraction, str], second: tuple[Fraction, str], width: Fraction
) -> Border:
    """Return a narrow bracket between two magnitudes of different verdicts."""
    low, high = first[0], second[0]
    undecided: list[Fraction] = []
    # Where the verdict changes at 0 no width is small beside the larger end.
    floor = width * high / _FLOOR
    while high - low > max(width * high, floor):
        for t in _between(low, high):
            answer = verdict(t)
            if answer != UNDECIDED:
                break
            undecided.append(t)
        else:
            break
        low, high = (t, high) if answer == first[1] else (low, t)
    ends = (low, high) if first[1] == RESISTED else (high, low)
    return Border(*ends, tuple(sorted(t for t in undecided if low < t < high)))


def _between(low: Fraction, high: Fraction) -> Iterator[Fraction]:
    """Yield simple numbers in the middle third, then nearer to both ends."""
    third = (high - low) / 3
    yield simplest_between(low + third, high - third)
    for k in range(1, _STUCK):
        part = third / 4**k
        yield simplest_between(low + part / 2, low + part)
        yield simplest_between(high - part, high - part / 2)
