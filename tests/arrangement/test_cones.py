"""Generators of cones by double description, compared with all choices of tight conditions."""

from itertools import combinations
from math import gcd, lcm
from random import Random

import pytest
from sympy import ZZ
from sympy.polys.matrices import DM

from arrangement.numbers.linear.cones import Cone, both_ways, generators
from arrangement.numbers.linear.rank import rank

Row = tuple[int, ...]


def dot(one: Row, other: Row) -> int:
    return sum(x * y for x, y in zip(one, other, strict=True))


def null_space(rows: list[Row], n: int) -> list[Row]:
    """Return a basis of what is orthogonal to some rows, in integers."""
    matrix = DM([*rows, (0,) * n], ZZ).to_field().nullspace().to_Matrix().tolist()
    return [tuple(int(x * lcm(*(y.q for y in row))) for x in row) for row in matrix]


def tight(rows: list[Row], vector: Row) -> frozenset[int]:
    return frozenset(i for i, row in enumerate(rows) if not dot(row, vector))


def extreme(rows: list[Row], flat: list[Row], n: int) -> set[frozenset[int]]:
    """Return what is tight at each extreme ray modulo the lines: it tells them apart."""
    lines = n - rank([*rows, *flat])
    found = set()
    for size in range(n):
        for chosen in combinations(rows, size):
            space = null_space([*chosen, *flat], n)
            if len(space) != lines + 1:
                continue
            for vector in (sign_of for v in space for sign_of in (v, tuple(-x for x in v))):
                values = [dot(row, vector) for row in rows]
                if any(values) and min(values) >= 0:
                    found.add(tight(rows, vector))
    return found


def drawn(seed: int) -> tuple[list[Row], list[Row], int]:
    random = Random(seed)
    n = random.randint(1, 4) if seed % 3 else 4
    rows = [tuple(random.randint(-2, 2) for _ in range(n)) for _ in range(random.randint(0, 6))]
    if rows and seed % 3 == 0:  # in a plane, which both conditions have in common
        rows.insert(0, tuple(-x for x in rows[0]))
    flat = [tuple(random.randint(-1, 1) for _ in range(n))] * random.choice([0, 0, 1])
    return rows, flat, n


@pytest.mark.parametrize("seed", range(30))
def test_rays_are_those_that_tight_conditions_leave(seed):
    rows, flat, n = drawn(seed)
    rays, lines = generators(rows, flat, n)
    assert len(lines) == n - rank([*rows, *flat]) == rank(lines)
    assert not any(dot(row, line) for row in [*rows, *flat] for line in lines)
    assert not any(dot(row, ray) for row in flat for ray in rays)
    assert all(dot(row, ray) >= 0 for row in rows for ray in rays)
    assert all(gcd(*vector) == 1 for vector in [*rays, *lines])
    assert list(rays) == sorted(rays)
    sets = [tight(rows, ray) for ray in rays]
    assert len({*sets}) == len(sets)
    assert {*sets} == extreme(rows, flat, n)


@pytest.mark.parametrize("seed", range(30))
def test_conditions_are_those_that_generators_need(seed):
    rows, flat, n = drawn(seed)
    found, conditions = both_ways(rows, flat, n)
    assert found == generators(rows, flat, n)
    facets, equations = conditions
    assert len(equations) == n - rank([*found[0], *found[1]])
    assert extreme([*found[0]], [*found[1]], n) == {tight([*found[0]], f) for f in facets}
    assert all(dot(f, ray) >= 0 for f in facets for ray in found[0])
    assert not any(dot(f, line) for f in [*facets, *equations] for line in found[1])
    assert not any(dot(e, ray) for e in equations for ray in found[0])
    # A condition that is dropped lets something else in.
    for facet in facets:
        others = [other for other in facets if other != facet]
        assert generators(others, equations, n) != found


@pytest.mark.parametrize("seed", range(30))
def test_cones_of_polyhedra_have_generators_where_there_are_points(seed):
    rows, flat, n = drawn(seed)
    last = (*(0,) * (n - 1), 1)
    rays, lines = generators([last, *rows], flat, n)
    found, conditions = both_ways(rows, flat, n, finite=True)
    assert found == generators(rows, flat, n, finite=True)
    if any(ray[-1] for ray in rays):
        assert found == (rays, lines)
        assert conditions == both_ways([last, *rows], flat, n)[1]
    else:
        assert found in [((), ()), (rays, lines)]  # it stops early, or sees at the end


def test_a_point_alone_has_equations():
    assert both_ways([], [(1, 1), (0, 2)], 2) == (((), ()), ((), ((1, 0), (0, 1))))


def test_copies_of_a_cone_are_cut_alone():
    cone = Cone(3)
    for row in ((1, 0, 0), (0, 1, 0), (0, 0, 1)):
        cone.cut(row, keep_positive=True)
    twin = cone.copy()
    twin.cut((1, 1, -1), keep_positive=True)
    cone.cut((1, -1, 0), keep_positive=False)
    assert twin.generators == generators([*Cone(3).lines, (1, 1, -1)], [], 3)
    assert cone.generators == (((0, 0, 1), (1, 1, 0)), ())
    assert cone.has_points
    cone.cut((0, 0, 1), keep_positive=False)
    assert not cone.has_points
