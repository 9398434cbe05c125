"""Grasps whose resisted magnitudes along a direction are not one interval that starts at 0.

A seeded search over small grasps, so that examples can be found again by anyone. A binary search
for the largest resisted magnitude is wrong on each of them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from random import Random
from typing import Any

from arrangement.console.progress import watched
from arrangement.numbers.exact import RationalVector, to_text
from arrangement.numbers.linear.intervals import Interval, texts
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp

from .space import resisted_set

_NORMALS = ((1, 0), (0, 1), (-1, 0), (0, -1))
_FRICTIONS = (Fraction(0), Fraction(1, 2), Fraction(1))
_AXES: tuple[RationalVector, ...] = tuple(
    tuple(Fraction(sign * (i == j)) for j in range(3)) for i in range(3) for sign in (1, -1)
)


@dataclass(frozen=True)
class Gap:
    """A grasp with a direction along which its resisted magnitudes are not one interval from 0."""

    grasp: Grasp
    direction: RationalVector
    intervals: tuple[Interval, ...]

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form; numbers are strings, null means no end."""
        return {
            "grasp": self.grasp.to_dict(),
            "direction": [to_text(x) for x in self.direction],
            "intervals": list(map(texts, self.intervals)),
        }


def gaps(contacts: int, seed: int, tries: int) -> Iterator[Gap]:
    """Yield the examples among random small grasps with preload 1, along the six axes of wrenches.

    Points have coordinates -1, 0, 1, normals are along the axes, friction is 0, 1/2 or 1.
    """
    random = Random(seed)
    for _ in watched(range(tries), "grasps"):
        grasp = Grasp(_contact(random) for _ in range(contacts))
        whole = resisted_set(grasp)
        for direction in _AXES:
            found = whole.along(direction)
            if found and (len(found) > 1 or found[0][0] != 0):
                yield Gap(grasp, direction, found)


def _contact(random: Random) -> Contact:
    point = (random.randint(-1, 1), random.randint(-1, 1))
    return Contact(point, random.choice(_NORMALS), random.choice(_FRICTIONS), 1, 1)
