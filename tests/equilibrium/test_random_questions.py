"""Random questions against brute force: smallest wrenches, arrays of loads, bounded displacements.

The other route is the oracle: every choice of contact states, decided exactly. Contacts coincide,
lack friction or preload, or are none at all. Extended tests ask 2,000 questions of each kind.
"""

from collections.abc import Iterator
from fractions import Fraction
from itertools import islice
from math import isqrt
from random import Random

import numpy as np
import pytest

from arrangement.numbers.exact import from_floats
from equilibrium import Contact, Grasp, ResistedSet, solve, solve_many
from equilibrium.grasps.inputs import from_float_data

from .degenerate import less
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
NUMBERS = [0, *[1] * 8, *[2] * 18, 3]
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


def of_length(direction, square_of_length):
    """Return a vector along a direction whose square of length is nearly, and not above, that."""
    share = square_of_length / square(direction)
    length = Fraction(
        isqrt(share.numerator * share.denominator * 10**12), share.denominator * 10**6
    )
    return tuple(length * x for x in direction)


def is_smallest_unresisted(grasp, source):
    """Return whether no load inside of the ball is unresisted, and one just beyond it is."""
    found = ResistedSet(grasp).smallest_outside()
    size = found.size_squared
    directions = [source.choice([tuple(source.randint(-3, 3) for _ in range(3)), *AXES[:2]])]
    if found.wrench is not None:
        directions.append(found.wrench)
    # A load of any size, where all are resisted.
    inside = [of_length(x, 100 if size is None else size) for x in directions if any(x)]
    if not all(is_stable(grasp, load) for load in inside):
        return False
    if size is None:
        return True
    near = square([x - y for x, y in zip(found.beyond, found.wrench, strict=True)])
    return (
        near * 10**6 <= (size or 1)
        and square(found.wrench) == size
        and not is_stable(grasp, found.beyond)
    )


def bounded_load(grasp, source):
    """Return a load: a sum of forces in the friction cones, or on a grid in three of ten cases."""
    if source.random() < 0.3:
        return tuple(Fraction(source.randint(-4, 4), 2) for _ in range(3))
    load = (Fraction(0),) * 3
    for contact in grasp:
        push = Fraction(source.randint(0, 4), 2)
        load = less(load, contact, push, push * contact.friction * source.randint(-2, 2) / 2)
    return load


def bounds_agree(grasp, source, loads=1):
    """Return whether loads have equilibria within a largest displacement exactly if so decided."""
    bound = source.choice([Fraction(0), Fraction(1, 2), Fraction(source.randint(1, 64), 16)])
    asked = [bounded_load(grasp, source) for _ in range(loads)]
    if loads == 1:
        found = [solve(grasp, asked[0], max_displacement=bound)]
    else:
        found = list(solve_many(grasp, asked, max_displacement=bound))
    return [verdict.stable for verdict in found] == [
        is_stable(grasp, load, displacement=bound) for load in asked
    ]


def ten_bounds_agree(grasp, source):
    return bounds_agree(grasp, source, 10)


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


def test_bounded_displacements_agree_with_brute_force():
    assert asked("bounds", 5, bounds_agree) == []
    assert asked("bounds", 1, ten_bounds_agree) == []


#: Of each slow test: what is asked of a grasp, how many grasps a part has, questions of a grasp.
#: With the hundred of tests/equilibrium/test_displacement.py each kind of question is asked 1,000
#: times: smallest wrenches, loads in arrays, and loads with a largest displacement.
MANY = {
    "wrench": (is_smallest_unresisted, 100, 1),
    "loads": (loads_agree, 10, 10),
    "bound": (bounds_agree, 20, 1),
    "bounds": (ten_bounds_agree, 8, 10),
}


@pytest.mark.slow
@pytest.mark.parametrize("part", range(10))
@pytest.mark.parametrize("name", MANY)
def test_many_questions_agree_with_brute_force(name, part):
    answer, number, _ = MANY[name]
    assert asked(f"{name} {part}", number, answer) == []


def test_slow_tests_ask_a_thousand_questions_of_each_kind():
    counts = {name: 10 * number * each for name, (_, number, each) in MANY.items()}
    assert counts == {"wrench": 1000, "loads": 1000, "bound": 200, "bounds": 800}
