"""The intersection lattice and its Moebius function."""

import math
from itertools import combinations

import pytest
from hypothesis import given, strategies as st

from arrangement import Arrangement, InputError, counts

from . import oracle
from .strategies import arrangements


def closure_by_ranks(planes: Arrangement, chosen: tuple[int, ...]) -> tuple[int, ...] | None:
    """Return all planes through the intersection of some, from ranks alone; None if empty."""
    augmented = [(*n, b) for n, b in zip(planes.normals, planes.offsets, strict=True)]
    rows = [augmented[i] for i in chosen]
    size = oracle.rank(rows)
    if oracle.rank([row[:-1] for row in rows]) < size:
        return None
    return tuple(i for i, row in enumerate(augmented) if oracle.rank([*rows, row]) == size)


@given(arrangements(dimensions=(1, 4), planes=(0, 5)))
def test_flats_are_the_closed_sets_with_common_points(planes):
    expected = set()
    for size in range(len(planes) + 1):
        for chosen in combinations(range(len(planes)), size):
            closed = closure_by_ranks(planes, chosen)
            if closed is not None:
                expected.add((closed, oracle.rank([planes.normals[i] for i in closed])))
    lattice = counts.intersection_lattice(planes)
    found = [(flat.planes, flat.rank) for level in lattice.flats for flat in level]
    assert len(found) == len(set(found))
    assert set(found) == expected


@given(arrangements(dimensions=(1, 4), planes=(0, 7)))
def test_moebius_sums_to_zero_below_every_flat(planes):
    values = counts.moebius(planes)
    for flat in values:
        below = sum(value for other, value in values.items() if {*other.planes} <= {*flat.planes})
        assert below == (1 if flat.rank == 0 else 0)
        assert (-1) ** flat.rank * values[flat] > 0  # Rota's sign theorem


@given(arrangements(dimensions=(1, 4), planes=(0, 7)))
def test_covers_are_the_next_larger_flats(planes):
    lattice = counts.intersection_lattice(planes)
    for rank, (level, covers) in enumerate(zip(lattice.flats, lattice.covers, strict=True)):
        above = lattice.flats[rank + 1] if rank + 1 < len(lattice.flats) else ()
        for flat, found in zip(level, covers, strict=True):
            expected = {g.planes for g in above if {*flat.planes} <= {*g.planes}}
            assert {above[i].planes for i in found} == expected
            assert len(found) == len(expected)
            assert flat.dimension == planes.dimension - rank


@given(arrangements(dimensions=(1, 4), planes=(1, 6)), st.data())
def test_closure_is_the_smallest_flat(planes, data):
    chosen = tuple(data.draw(st.sets(st.integers(0, len(planes) - 1), max_size=4)))
    flat = counts.intersection_lattice(planes).closure(chosen)
    assert (flat and flat.planes) == (closure_by_ranks(planes, chosen) if chosen else ())


def test_generic_flats_are_all_small_subsets():
    planes = Arrangement([[1, t, t**2, t**3, t**4] for t in range(8)])
    sizes = [len(level) for level in counts.intersection_lattice(planes).flats]
    assert sizes == [math.comb(8, k) for k in range(5)] + [1]


@pytest.mark.parametrize("plane", [-1, 2, True])
def test_closure_refuses_planes_that_do_not_exist(plane):
    lattice = counts.intersection_lattice(Arrangement([[1, 0], [0, 1]]))
    with pytest.raises(InputError, match="does not exist"):
        lattice.closure([plane])


def test_whitney_numbers_of_both_kinds_of_the_partition_lattice():
    # Stirling numbers of the first and second kind, OEIS A008275 and A008277
    rows = [[(k == i) - (k == j) for k in range(6)] for i, j in combinations(range(6), 2)]
    numbers = counts.whitney_numbers(Arrangement(rows))
    assert numbers.first == (1, -15, 85, -225, 274, -120)
    assert numbers.second == (1, 15, 65, 90, 31, 1)
