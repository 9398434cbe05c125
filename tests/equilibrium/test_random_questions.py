"""Random questions of the smallest wrench and of arrays of loads, against brute force.

The other route is the oracle: every choice of contact states, decided exactly. Contacts coincide,
lack friction or preload, or are none at all. The whole of 1,300 questions is an extended test.
"""

from collections.abc import Iterator
from fractions import Fraction
from itertools import islice
from random import Random

import numpy as np
import pytest

from arrangement.numbers.exact import from_floats
from equilibrium import Contact, Grasp, ResistedSet
from equilibrium.grasps.inputs import from_float_data

from .oracle import intervals, is_stable

NORMALS = [(1, 0), (0, 1), (-1, 0), (0, -1)]
NORMALS += [
    (Fraction(s * a, c), Fraction(t * b, c))
    for a, b, c in ((3, 4, 5), (4, 3, 5), (5, 12, 13), (12, 5, 13))
    for s in (1, -1)
    for t in (1, -1)
]
FRICTIONS = [Fraction(0), Fraction(1, 3), Fraction(1, 2), Fraction(7, 10), Fraction(1), Fraction(2)]
#: How often there are this many contacts.
NUMBERS = [0, *[1] * 4, *[2] * 12, *[3] * 3]
AXES = [tuple(side * (i == j) for j in range(3)) for i in range(3) for side in (1, -1)]


def random_contact(source: Random) -> Contact:
    point = [Fraction(source.randint(-6, 6), 2) for _ in range(2)]
    values = (
        source.choice(FRICTIONS),
        source.choice([1, 2, Fraction(1, 2)]),
        source.choice([0, Fraction(1, 2), 1, 1, 2]),
    )
    return Contact(point, source.choice(NORMALS), *values)


def random_grasps(seed: str) -> Iterator[Grasp]:
    """Yield grasps; in one of five one contact stands twice, in one of five none has preload."""
    source = Random(seed)
    while True:
        contacts = [random_contact(source) for _ in range(source.choice(NUMBERS))]
        kind = source.randrange(5)
        if kind == 0 and len(contacts) > 1:
            contacts[0] = contacts[1]
        grasp = Grasp(contacts)
        yield grasp.with_preload(0) if kind == 1 else grasp


def square(wrench):
    return sum(x * x for x in wrench)


def is_smallest_unresisted(grasp, source):
    """Return whether no ray of the oracle ends earlier, and one just beyond the boundary has."""
    found = ResistedSet(grasp).smallest_outside()
    directions = [tuple(source.randint(-3, 3) for _ in range(3)), source.choice(AXES)]
    if found.wrench is not None and any(found.wrench):
        directions.append(found.wrench)
    for along in filter(any, directions):
        parts = intervals(grasp, along, (0, 0, 0))
        end = parts[0][1] if parts and parts[0][0] == 0 else Fraction(0)
        if end is not None and (
            found.size_squared is None or end**2 * square(along) < found.size_squared
        ):
            return False
    if found.size_squared is None:
        return True
    near = square([x - y for x, y in zip(found.beyond, found.wrench, strict=True)])
    close = near * 10**6 <= (found.size_squared or 1)
    return (
        close and square(found.wrench) == found.size_squared and not is_stable(grasp, found.beyond)
    )


def random_loads(grasp: Grasp, source: Random) -> np.ndarray:
    """Return loads on a grid, where boundaries are; and those at the boundary along a direction."""
    along = source.choice(AXES)
    ends = [end for part in intervals(grasp, along, (0, 0, 0)) for end in part if end is not None]
    rows = [[float(end) * x for x in along] for end in ends[:2]]
    rows += [[0.0, 0.0, 0.0], [1e-80, -1.0, 1e80]]
    while len(rows) < 10:
        rows.append([source.randint(-4, 4) * source.choice([0.5, 0.4, 1.2]) for _ in range(3)])
    return np.array(rows)


def loads_agree(grasp, source):
    columns = [[float(getattr(c, name)) for c in grasp] for name in ("friction", "preload")]
    points, normals = ([[*map(float, getattr(c, k))] for c in grasp] for k in ("point", "normal"))
    stiffness = [float(c.stiffness) for c in grasp]
    loads = random_loads(grasp, source)
    values = {"preload": columns[1], "stiffness": stiffness}
    made = from_float_data(points, normals, columns[0], **values).grasp
    found = ResistedSet(made).check(loads)
    assert found.grasp == grasp
    return found.resisted.tolist() == [is_stable(grasp, from_floats(load)) for load in loads]


def asked(seed, number, answer):
    """Return the numbers of the grasps of a seed for which an answer is wrong."""
    source = Random(seed)
    grasps = islice(random_grasps(seed), number)
    return [k for k, grasp in enumerate(grasps) if not answer(grasp, source)]


def test_smallest_wrench_agrees_with_brute_force():
    assert asked("wrench", 12, is_smallest_unresisted) == []


def test_arrays_of_loads_agree_with_brute_force():
    assert asked("loads", 8, loads_agree) == []


@pytest.mark.slow
@pytest.mark.parametrize("part", range(10))
def test_thirty_smallest_wrenches_agree_with_brute_force(part):
    assert asked(f"wrench {part}", 30, is_smallest_unresisted) == []


@pytest.mark.slow
@pytest.mark.parametrize("part", range(10))
def test_hundred_loads_agree_with_brute_force(part):
    assert asked(f"loads {part}", 10, loads_agree) == []
