"""The exact test of leaves says what a second, naive evaluation says, on regions of every size."""

from fractions import Fraction
from random import Random
from typing import Any

import pytest

from equilibrium.core.contacts import IntegerContacts
from equilibrium.plane.search.motion_regions import ORTHANTS
from equilibrium.plane.search.virtual_motions import _exact_multiplier, closed

from . import judge
from .degenerate import Question, question

Region = tuple[tuple[int, ...], ...]


def region(source: Random) -> Region:
    """Return an orthant, cut at the middle of edges up to eight times."""
    found: list[tuple[int, ...]] = list(source.choice(ORTHANTS))
    for _ in range(source.randrange(9)):
        j, k = source.sample(range(4), 2)
        found[j] = tuple(a + b for a, b in zip(found[j], found[k], strict=True))
    return tuple(found)


def answers(asked: Question, regions: list[Region], motions: list[list[int]]) -> list[bool]:
    """Return what the exact test says, after a comparison with the naive one."""
    wrench = tuple(asked.wrench)
    tested = closed(IntegerContacts(asked.grasp), wrench, regions, motions)
    found = [multiplier is not None for multiplier in tested]
    for generators, motion, answer in zip(regions, motions, found, strict=True):
        rows = [[Fraction(x) for x in g] for g in generators]
        leaf: Any = [str(x) for x in motion]
        assert answer == judge.leaf_holds(asked.grasp, wrench, leaf, rows, {})
    return found


@pytest.mark.parametrize(
    ("work", "beyond", "weight", "found"),
    [
        ([-2, 9], [-1, 3], [1, 1], "5/2"),
        ([-2, 4], [-1, 0], [1, 1], "5"),
        ([2, 9], [-1, 3], [1, 1], "3/2"),
        ([-2, 0], [-1, 0], [1, 0], "5"),
        ([-2, 0], [-1, 0], [1, 1], None),
        ([-3, 3], [-1, 3], [1, 1], None),
        ([-3, 9], [-1, 3], [1, 1], None),
        ([2, 9], [1, 3], [1, 1], None),
        ([-2, 4], [-(10**12), 10**12], [1, 1], "3/1000000000000"),
        ([2, 4], [-(10**12), 10**12], [1, 1], "1/500000000000"),
        ([-2, -1], [-1, 0], [1, 0], None),
        ([-2, -5, 1], [-1, -1, 0], [1, 1, 1], "11"),
        ([-2, 9, 5], [-1, 1, 1], [1, 1, 1], "7/2"),
        ([-3, 9, 0], [-1, 1, 0], [1, 1, 0], "6"),
        ([-4, 8], [-2, 2], [0, 1], "3"),
        ([-2, 4], [-1, 2], [0, 0], "2"),
    ],
)
def test_multiplier_of_a_bound_leaves_all_works_above_0(work, beyond, weight, found):
    assert _exact_multiplier(work, beyond, weight) == (found and Fraction(found))


@pytest.mark.parametrize("size", [1, 3, 10**12])
def test_the_answer_is_that_of_a_naive_evaluation(size):
    source = Random(f"leaves {size}")
    found: list[bool] = []
    for seed in range(20):
        asked = question(seed)
        regions = [region(source) for _ in range(12)]
        if seed % 2:
            motions = [[source.randint(-size, size) for _ in range(3)] for _ in regions]
        else:
            # Against which the load surely works.
            along = [round(w * size) for w in asked.wrench]
            motions = [[x + source.randint(-1, 1) for x in along] for _ in regions]
        found += answers(asked, regions, motions)
    assert 10 < sum(found) < len(found) - 10
