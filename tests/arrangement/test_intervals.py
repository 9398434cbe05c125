"""Unions of intervals contain the points that a definition point by point says."""

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise, product
from random import Random

from arrangement.numbers.linear import intervals
from arrangement.numbers.linear.intervals import Interval

#: All ends of what is drawn, points between them, and points beyond.
ENDS = [Fraction(k) for k in range(-2, 3)]
POINTS = [Fraction(k, 2) for k in range(-7, 8)]
BETWEEN = [x for x in POINTS if x.denominator > 1]


def inside(interval: Interval | None, x: Fraction) -> bool:
    if interval is None:
        return False
    low, high = interval
    return (low is None or low <= x) and (high is None or x <= high)


def drawn(random: Random) -> Interval:
    low, high = sorted(random.choices(ENDS, k=2))
    return random.choice([None, low, low]), random.choice([None, high, high])


EVERY: list[Interval] = [
    (low, high)
    for low, high in product([None, *ENDS], repeat=2)
    if low is None or high is None or low <= high
]


def rows_of_lines(random: Random) -> Iterator[list[tuple[int, int]]]:
    lines = list(product(range(-2, 3), range(-2, 3)))
    yield from map(list, product(lines, repeat=2))
    for _ in range(200):
        yield random.choices(lines, k=random.choice([1, 3, 4]))


def test_where_rows_are_positive():
    for rows in rows_of_lines(Random(0)):
        found = intervals.where_positive(rows)
        ends = {Fraction(-constant, slope) for slope, constant in rows if slope}
        between = [(x + y) / 2 for x, y in pairwise(sorted(ends))]
        for x in [*ends, *between, Fraction(-9), Fraction(9)]:
            assert inside(found, x) == all(slope * x + constant >= 0 for slope, constant in rows)
        assert found is None or ends >= {end for end in found if end is not None}


def test_rows_without_slope_hold_everywhere_or_nowhere():
    assert intervals.where_positive([]) == intervals.where_positive([(0, 0), (0, 1)])
    assert intervals.where_positive([(0, 0)]) == intervals.LINE == (None, None)
    assert intervals.where_positive([(1, 0), (0, -1)]) is None
    assert intervals.where_positive([(1, -1), (-1, 1)]) == (1, 1)
    assert intervals.where_positive([(2, -1), (-1, Fraction(1, 4))]) is None


def lists_of_intervals(random: Random) -> Iterator[list[Interval]]:
    yield from ([], *map(list, product(EVERY, repeat=2)))
    for _ in range(100):
        yield [drawn(random) for _ in range(random.choice([1, 3, 4]))]


def test_unions_are_disjoint_in_order_and_have_the_same_points():
    random = Random(0)
    for some in lists_of_intervals(random):
        others = [drawn(random) for _ in range(random.randint(0, 2))]
        united, shared = intervals.union(some), intervals.common(some, others)
        for x in POINTS:
            in_some = any(inside(part, x) for part in some)
            assert intervals.holds(some, x) == in_some
            assert any(inside(part, x) for part in united) == in_some
            both = in_some and any(inside(part, x) for part in others)
            assert any(inside(part, x) for part in shared) == both
        for found in (united, shared):
            for (_, high), (low, _) in pairwise(found):
                assert high < low


def test_intersections_have_the_common_points():
    points = {part: [inside(part, x) for x in POINTS] for part in [None, *EVERY]}
    for one, other in product(EVERY, repeat=2):
        both = intervals.intersection(one, other)
        shared = [x and y for x, y in zip(points[one], points[other], strict=True)]
        assert points[both] == shared
        assert (both is None) == (not any(shared))
    for one in EVERY:
        assert intervals.is_long(one) == (sum(points[one]) > 1)


def test_what_is_left_are_long_closed_parts():
    random = Random(0)
    for removed in lists_of_intervals(random):
        whole = drawn(random)
        left = intervals.remainder(whole, removed)
        for x in BETWEEN:
            rest = inside(whole, x) and not any(inside(part, x) for part in removed)
            assert any(inside(part, x) for part in left) == rest
        assert all(low is None or high is None or low < high for low, high in left)
        for (_, high), (low, _) in pairwise(left):
            assert high <= low


def test_ends_are_written_as_texts():
    assert intervals.texts((None, Fraction(1, 3))) == [None, "1/3"]
    assert intervals.texts((Fraction(-2), None)) == ["-2", None]
