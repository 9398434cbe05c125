"""Seeded questions (grasp, wrench) of two to five contacts in which degenerate cases are common.

Coincident planes, shared points, opposite normals, no friction, no preload or some, soft springs
(large motions); wrenches on the exact boundary of what a grasp resists, and 10^-30 beside it.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from random import Random

from equilibrium import Contact, Grasp
from equilibrium.grasps.inputs.random import random_grasp
from equilibrium.wrench_sets.line import resisted_magnitudes

Wrench = tuple[Fraction, ...]
TINY = Fraction(1, 10**30)
AXES = [(1, 0), (0, 1), (-1, 0), (0, -1)]
NORMALS = [*AXES, (Fraction(3, 5), Fraction(4, 5)), (Fraction(-4, 5), Fraction(3, 5))]
HALVES = [Fraction(n, 2) for n in range(-4, 5)]
BORDERS = {"border": Fraction(0), "inside": -TINY, "outside": TINY}


@dataclass(frozen=True)
class Question:
    """A grasp and a wrench, with the names of how they were made."""

    seed: int
    grasp: Grasp
    wrench: Wrench
    kind: str
    load: str


@cache
def question(seed: int) -> Question:
    """Return the question of a seed; the number of contacts goes round 2, 3, 4, 5."""
    source = Random(f"awkward {seed}")
    kind, make = source.choice(list(GRASPS.items()))
    grasp = make(source, 2 + seed % 4)
    load = source.choice(["free", "free", "zero", *BORDERS, *BORDERS])
    wrench: Wrench | None = (Fraction(0),) * 3
    if load in BORDERS:
        wrench = _near_border(source, grasp, BORDERS[load])
    if load == "free" or wrench is None:
        load, wrench = "free", source.choice([_free, _opposed])(source, grasp)
    return Question(seed, grasp, wrench, kind, load)


def _free(source: Random, _: Grasp) -> Wrench:
    if source.random() < 0.5:
        return tuple(source.choice(HALVES) for _ in range(3))
    return tuple(Fraction(source.randint(-128, 128), 64) for _ in range(3))


def _opposed(source: Random, grasp: Grasp) -> Wrench:
    """Return the negative of a sum of forces in the friction cones of some contacts."""
    total: Wrench = (Fraction(0),) * 3
    for contact in grasp:
        push = Fraction(source.randint(0, 2))
        total = less(total, contact, push, push * contact.friction * source.randint(-2, 2) / 2)
    return total


def less(wrench: Wrench, contact: Contact, *forces: Fraction) -> Wrench:
    """Return a wrench less that of forces at a contact, along its normal and tangents."""
    rows = contact.normal_wrench, *contact.tangential_wrenches
    for force, row in zip(forces, rows, strict=True):
        wrench = tuple(w - force * x for w, x in zip(wrench, row, strict=True))
    return wrench


def _near_border(source: Random, grasp: Grasp, beyond: Fraction) -> Wrench | None:
    """Return a wrench at an exact end of the magnitudes resisted in some direction, or beside it.

    Without preload all of the set is a cone, so the magnitudes count from a wrench that acts.
    """
    for _ in range(4):
        base, direction = _opposed(source, grasp), _free(source, grasp)
        if not any(direction):
            continue
        intervals = resisted_magnitudes(grasp, direction, base).intervals
        ends = [(low, -1) for low, _ in intervals if low]
        ends += [(high, 1) for _, high in intervals if high]
        if ends:
            end, outward = source.choice(ends)
            factor = end * (1 + outward * beyond)
            return tuple(b + factor * w for b, w in zip(base, direction, strict=True))
    return None


def _contact(source: Random) -> Contact:
    """Return a contact on a coarse grid."""
    return Contact(
        (source.randint(-1, 1), source.randint(-1, 1)),
        source.choice(NORMALS),
        source.choice([0, Fraction(1, 2), 1]),
        source.choice([1, 2]),
        source.choice([0, 0, 1]),
    )


def _grid(source: Random, m: int) -> Grasp:
    return Grasp(_contact(source) for _ in range(m))


def _around(source: Random, m: int) -> Grasp:
    return random_grasp(m, source.randrange(10**6))


def _soft(source: Random, m: int) -> Grasp:
    """Springs a hundred times softer: motions a hundred times as large."""
    grasp = _around(source, m)
    return Grasp(replace(c, stiffness=c.stiffness / 100) for c in grasp)


def _some_preload(source: Random, m: int) -> Grasp:
    grasp = random_grasp(m, source.randrange(10**6), preload=True)
    return Grasp(replace(c, preload=c.preload * source.randint(0, 1)) for c in grasp)


def _no_friction(source: Random, m: int) -> Grasp:
    return Grasp(replace(c, friction=Fraction(0)) for c in _grid(source, m))


def _one_point(source: Random, m: int) -> Grasp:
    point = (source.randint(-1, 1), source.randint(-1, 1))
    return Grasp(replace(_contact(source), point=tuple(map(Fraction, point))) for _ in range(m))


def _opposite(source: Random, m: int) -> Grasp:
    """Contacts in pairs, each pair with one line of normals, pushing against one another."""
    contacts: list[Contact] = []
    while len(contacts) < m:
        one = _contact(source)
        (x, y), (nx, ny) = one.point, one.normal
        width = source.choice([0, 1, 2])
        other = replace(one, point=(x + width * nx, y + width * ny), normal=(-nx, -ny))
        contacts += [one, other]
    return Grasp(contacts[:m])


def _coincident(source: Random, m: int) -> Grasp:
    """Contacts moved along the tangent or the normal: one tangential or one normal plane."""
    contacts = [_contact(source)]
    while len(contacts) < m:
        (x, y), (nx, ny) = (base := source.choice(contacts)).point, base.normal
        along = source.choice([(nx, ny), (-ny, nx), (0, 0)])
        step = source.choice([-2, -1, 1, 2])
        moved = (x + step * along[0], y + step * along[1])
        contacts.append(replace(_contact(source), point=moved, normal=(nx, ny)))
    return Grasp(contacts)


GRASPS: dict[str, Callable[[Random, int], Grasp]] = {
    "around": _around,
    "some preload": _some_preload,
    "soft springs": _soft,
    "grid": _grid,
    "no friction": _no_friction,
    "one point": _one_point,
    "opposite": _opposite,
    "coincident": _coincident,
}
