"""Corners of bounds are within them, and their contacts do the most work there."""

import math
from dataclasses import replace
from fractions import Fraction
from random import Random
from types import SimpleNamespace

import pytest

from arrangement.numbers.exact import dot, sign
from equilibrium import Contact, Grasp
from equilibrium.certificate.uncertain import Bounds
from equilibrium.decide import NOT_RESISTED, RESISTED, corners
from equilibrium.model.contact import VALUES, wrench_at
from equilibrium.model.solution import Leaf

BOUNDS = Bounds(
    degrees=2, length="1/50", friction="10%", stiffness="20%", preload="30%", adhesion="40%"
)
FINGERS = {
    2: Contact(("1/2", -1), ("3/5", "4/5"), "1/3", 5, 2, stiffness_given=True, adhesion=1),
    3: Contact(
        (1, "-1/2", 2), ("2/7", "3/7", "6/7"), "1/3", 5, 2, stiffness_given=True, adhesion=1
    ),
}
#: A virtual motion and a motion.
MOTIONS = {
    2: ((2, 1, -1), (Fraction(-1, 9), Fraction(1, 8), 0)),
    3: ((3, 1, -2, 1, -1, 2), (Fraction(1, 9), 0, 0, 0, Fraction(1, 8), 0)),
}


@pytest.mark.parametrize("d", FINGERS)
def test_a_contact_moves_to_the_corner_that_its_signs_name(d):
    old, source = FINGERS[d], Random(d)
    for _ in range(12):
        signs = [source.choice((-1, 1)) for _ in range(2 * d + 3)]
        new = corners.moved(old, signs, BOUNDS)
        angle = math.degrees(math.acos(dot(old.normal, new.normal)))
        assert 1.9 < angle <= 2
        assert [sign(dot(new.normal, x)) for x in old.tangents] == signs[: d - 1]
        shifts = [(x - y) * 50 for x, y in zip(new.point, old.point, strict=True)]
        shares = [getattr(new, x) / getattr(old, x) - 1 for x in VALUES]
        sizes = (getattr(BOUNDS, x) for x in VALUES)
        assert shifts + [x / y for x, y in zip(shares, sizes, strict=True)] == signs[d - 1 :]
        assert new.stiffness_given


@pytest.mark.parametrize(
    ("normal", "degrees"), [(("8/33", "8/33", "31/33"), 1), (("-14/111", "85/111", "70/111"), 5)]
)
def test_two_turns_together_stay_within_the_angle(normal, degrees):
    """The rational normals near those wanted are almost as far off as they may be."""
    old, way = Contact([0, 0, 0], normal, 0), 2 * (degrees > 1) - 1
    new = corners.moved(old, [way, way, *[0] * 7], Bounds(degrees=degrees))
    assert math.degrees(math.acos(dot(old.normal, new.normal))) <= degrees


def test_a_contact_turns_about_one_axis_or_none():
    turned = corners.moved(FINGERS[3], [0, 1, *[0] * 7], BOUNDS)
    assert turned.normal != FINGERS[3].normal
    assert turned.point == FINGERS[3].point
    assert corners.moved(FINGERS[3], [1] * 9, Bounds(length=1)).normal == FINGERS[3].normal


@pytest.mark.parametrize("d", FINGERS)
@pytest.mark.parametrize(
    ("friction", "slips"), [("1/3", True), (2, True), (1, False)], ids=["little", "much", "none"]
)
def test_each_sign_is_that_of_the_change_of_work(d, friction, slips):
    old, (virtual, motion) = replace(FINGERS[d], friction=Fraction(friction)), MOTIONS[d]
    if not slips:
        virtual = (*old.normal, *[0] * (len(virtual) - d))
    along = [dot(row, virtual) for row in old.tangential_wrenches]
    size = sum(map(abs, along)) or 1
    small = Bounds(degrees="1/10000", length="1/10000", **dict.fromkeys(VALUES, "1/10000"))

    def work(new):
        force = old.force([Fraction(1), *(-new.friction * Fraction(x) / size for x in along)])
        # It turns with the normal.
        turn = [x - y for x, y in zip(new.normal, old.normal, strict=True)]
        pressed, back = dot(old.normal, force), dot(turn, force)
        turned = zip(force, turn, old.normal, strict=True)
        force = tuple(f + t * pressed - n * back for f, t, n in turned)
        spring = new.preload - new.stiffness * dot(old.normal_wrench, motion)
        assert spring > 0
        pulled = new.adhesion * dot(wrench_at(new.point, new.normal), virtual)
        return spring * dot(wrench_at(new.point, force), virtual) - pulled

    signs = []
    for j in range(2 * d + 3):
        one = corners.moved(old, [int(j == k) for k in range(2 * d + 3)], small)
        change = work(one) - work(old)
        signs.append(sign(change) if abs(change) > 1e-7 else 0)
    assert corners._working(old, virtual, motion, 1) == signs
    assert corners._working(old, virtual, motion, -1) == [-x for x in signs]


def test_friction_of_a_contact_that_presses_nothing_stays():
    far = (3, 4, 0)
    assert corners._working(FINGERS[2], MOTIONS[2][0], far, 1)[3] == 0


def tree(d):
    """Return a proof: three of its virtual motions are tried, the second was tried before."""
    more = [0] * (3 * d - 5)
    motions = [(0, 1), (1, 0), (1, 1), (-1, 1), *[(9, -9)] * (3 * d - 5)]
    first, second, *rest = [Leaf((*motion, *more), {}) for motion in motions]
    # A leaf in a plane, or of one body of several, has another number of coordinates.
    other = Leaf((1,) * (9 - 3 * d + 3), {})
    return {
        "contact": 1,
        "at": ["1", "1"],
        "slip": {"stick": other, "slip+": first},
        "on": [second, *rest],
    }


@pytest.mark.parametrize(
    ("d", "verdict", "most", "at_rest"),
    [(2, RESISTED, 1, True), (3, RESISTED, 1, False), (2, NOT_RESISTED, -1, False)],
)
def test_corners_come_in_order_and_none_twice(d, verdict, most, at_rest):
    other = Contact([-1, *[0] * (d - 1)], [1, *[0] * (d - 1)], "1/2", 2, 3)
    grasp, load = Grasp([FINGERS[d], other]), (1, 0, *[0] * (3 * d - 5))
    motion = (0,) * len(load) if at_rest else MOTIONS[d][1]
    found = SimpleNamespace(subject=grasp, load=load, flat=tuple, verdict=verdict)
    found.tree = tree(d)
    found.solution = None if at_rest else SimpleNamespace(motion=motion)
    answers = [None, SimpleNamespace(verdict=NOT_RESISTED, tree=tree(d))]
    if not at_rest:
        answers[0] = SimpleNamespace(verdict=RESISTED, tree=Leaf((5, -7, *load[2:]), {}))
    asked = []

    def decide(*question):
        asked.append(question)
        return answers[len(asked) - 1]

    *first, one, two, three, four = corners.corners(found, BOUNDS, decide)
    rows = [[[0] * (2 * d - 1) + [end] * 3 + [-end] for _ in grasp] for end in (-most, most)]
    begun = [load, (0, 1, *load[2:])][::most]
    rows += [
        [corners._working(contact, virtual, motion, most) for contact in grasp]
        for virtual in (*begun, (1, 1, *load[2:]))
    ]
    assert first == [
        Grasp(corners.moved(c, row, BOUNDS) for c, row in zip(grasp, pair, strict=True))
        for pair in rows
    ]
    larger = [tuple((1 + x) * y for y in load) for x in corners.LARGER_LOAD_SHARES]
    assert asked == ([(grasp, load) for load in larger] if most > 0 else [])
    inner = (one, two, three, four)
    shifts = [
        (x - y) * 50
        for grasp_within in inner
        for old, new in zip(grasp, grasp_within, strict=True)
        for x, y in zip(new.point, old.point, strict=True)
    ]
    assert -1 < min(shifts) < -Fraction(1, 2)
    assert Fraction(1, 2) < max(shifts) < 1
    assert len(set(inner)) == 4
