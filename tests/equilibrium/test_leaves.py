"""The exact test of leaves says what a second, naive evaluation says, on regions of every size."""

from fractions import Fraction
from random import Random
from typing import Any

import numpy as np
import pytest

from arrangement.numbers.exact import dot
from equilibrium import Contact, Grasp
from equilibrium.certificate.contact_rule import broken_multipliers, greatest_product, within_room
from equilibrium.core.cones import LineCones, RoundCones
from equilibrium.core.contacts import FloatContacts, IntegerContacts
from equilibrium.core.leaves import Leaves
from equilibrium.model.rows import ContactRows
from equilibrium.model.solution import Leaf
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


def answers(
    asked: Question, regions: list[Region], motions: list[list[int]], factors: list[list[int]]
) -> list[bool]:
    """Return what the exact test says, after a comparison with the naive one."""
    wrench = tuple(asked.wrench)
    table = np.array(factors, dtype=float)
    tested = closed(
        IntegerContacts(ContactRows.of_grasp(asked.grasp)), wrench, regions, motions, table
    )
    found = [multiplier is not None for multiplier in tested]
    for generators, motion, row, answer in zip(regions, motions, factors, found, strict=True):
        rows = [[Fraction(x) for x in g] for g in generators]
        multipliers = {str(i): [str(x), "0"] for i, x in enumerate(row) if x}
        leaf: Any = {"virtual_motion": [str(x) for x in motion], "multipliers": multipliers}
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
    with_factors = []
    for seed in range(40):
        asked = question(seed)
        regions = [region(source) for _ in range(12)]
        if seed % 2:
            motions = [[source.randint(-size, size) for _ in range(3)] for _ in regions]
        else:
            # Against which the load surely works.
            along = [round(w * size) for w in asked.wrench]
            motions = [[x + source.randint(-1, 1) for x in along] for _ in regions]
        choices = (0, 0, 1, size // 4) if seed > 20 else (0,)
        factors = [[source.choice(choices) for _ in asked.grasp] for _ in regions]
        found += answers(asked, regions, motions, factors)
        with_factors += [any(row) for row in factors]
    assert 10 < sum(found) < len(found) - 10
    closed_by = [some for some, answer in zip(with_factors, found, strict=True) if answer]
    assert 0 < sum(closed_by) < min(len(closed_by), sum(with_factors))


#: Of one contact: in the plane with the names of certificates, in space with a sector.
STATES = {
    2: dict(zip(("slip+", "slip-"), LineCones().all, strict=True)),
    3: {"sector": ((1, 0), (0, 1)), "narrow": ((4, 3), (3, 4))},
}


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("beyond", [0, Fraction(1, 10**30), Fraction(-1, 10**30), 1, -1])
def test_contacts_of_leaves_obey_the_rule_of_certificates(dimension, beyond):
    """With multipliers at the largest that the rule allows, and next to it."""
    answers = set()
    for seed in range(40):
        source = Random(f"contact {dimension} {seed}")
        point, normal = ([source.randint(-3, 3) for _ in range(2)], [0, 1])
        contact = Contact(
            [*point, 0][:dimension], [0, *normal][-dimension:], Fraction(source.randint(0, 4), 4)
        )
        cones = LineCones() if dimension == 2 else RoundCones()
        rows = ContactRows.of_grasp(Grasp([contact]))
        leaves = Leaves(FloatContacts(rows), (Fraction(0),) * rows.n, cones)
        motion = [source.randint(-4, 4) for _ in range(rows.n)]
        motion[0] += not any(motion)
        (frame,) = rows
        a, *b = (dot(x, motion) for x in (frame.normal_wrench, *frame.tangential_wrenches))
        h = [source.choice((0, 0, 1, -1)) for _ in b]
        states = {x: x for x in ("undecided", "attached", "detached", "stick")} | STATES[dimension]
        for name, state in states.items():
            in_rule: Any = name if dimension == 2 or isinstance(state, str) else state
            if dimension == 2:
                most = contact.friction * greatest_product(b, in_rule, [(1,), (-1,)])
                alpha = a - most + beyond
                is_below = beyond <= 0
            else:
                alpha = a - Fraction(source.randint(-8, 8), 2) + beyond
                is_below = within_room(a - alpha, b, contact.friction, in_rule)
            expected = not broken_multipliers(in_rule, alpha, h, is_below=is_below)
            assert leaves._holds((state,), Leaf(tuple(motion), {0: [alpha, *h]}, {})) == expected
            answers.add((name, expected))
    assert {answer for _, answer in answers} == {True, False}
