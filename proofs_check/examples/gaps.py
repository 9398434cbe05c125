"""Where a binary search for the largest resisted force errs: resisted magnitudes with gaps.

Such a search assumes that a grasp which resists a wrench resists every smaller one in the same
direction. With preload that is false: a contact that detaches may take the friction of another one
with it, and a larger load may bring it back.

Change the numbers below for other random grasps. Run time: about 2 seconds.
"""

from collections.abc import Iterator
from fractions import Fraction
from random import Random

from arrangement.numbers.exact import RationalVector
from arrangement.numbers.linear.intervals import Interval
from equilibrium import Contact, Grasp, ResistedSet
from proofs_check import claim

SEED = 29
GRASPS = 12
CONTACTS = 3

FRICTIONS = (Fraction(0), Fraction(1, 2), Fraction(1))
NORMALS = ((1, 0), (0, 1), (-1, 0), (0, -1))
AXES = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))


def small_grasps(contacts: int, seed: int, count: int) -> Iterator[Grasp]:
    """Yield random grasps with preload 1, small coordinates and normals along the axes."""
    random = Random(seed)

    def contact() -> Contact:
        point = (random.randint(-1, 1), random.randint(-1, 1))
        return Contact(point, random.choice(NORMALS), random.choice(FRICTIONS), 1, 1)

    for _ in range(count):
        yield Grasp(contact() for _ in range(contacts))


def gaps(grasp: Grasp) -> Iterator[tuple[RationalVector, tuple[Interval, ...]]]:
    """Yield the axes along which the resisted magnitudes are not one interval from 0."""
    resisted = ResistedSet(grasp)
    for axis in AXES:
        intervals = resisted.margin(axis).intervals
        if intervals and (len(intervals) > 1 or intervals[0][0] != 0):
            yield tuple(map(Fraction, axis)), intervals


@claim(
    "A grasp that resists a wrench resists every smaller one in the same direction.",
    of={f"grasp {k}": grasp for k, grasp in enumerate(small_grasps(CONTACTS, SEED, GRASPS), 1)},
    locator="assumed by binary search",
    expected="refuted",
)
def no_gap(grasp: Grasp) -> bool | str:
    """Compute the resisted magnitudes along the six axes of wrenches, exactly."""
    for axis, intervals in gaps(grasp):
        parts = " or ".join(f"[{a}, {'oo' if b is None else b}]" for a, b in intervals)
        return f"along ({', '.join(map(str, axis))}) it resists the magnitudes {parts}"
    return True
