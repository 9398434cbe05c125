"""Proofs for all grasps within bounds: their arithmetic, genuine proofs and forged ones."""

import json
import math
from fractions import Fraction
from functools import cache
from itertools import product
from random import Random

import pytest

from arrangement.errors import InputError
from arrangement.numbers.exact import dot
from equilibrium import Contact, Grasp, solve
from equilibrium.certificate.checker import check
from equilibrium.certificate.robust import (
    Affine,
    Bounds,
    Box,
    _form,
    _largest,
    _length,
    _turning,
    _Uncertain,
    corners_of,
    halves,
)
from equilibrium.grasps.files import read_grasp
from equilibrium.model.errors import GraspError

from .test_checker import random_leaf

SPATIAL = [
    Contact(p, [-x for x in p], "1/2", 1, 1) for p in ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0))
]

#: A rational turn by just below two degrees; tan 1 degree is 0.017455064...
HALF_TURN = Fraction(17455, 10**6)
NEAR = Bounds(degrees=2, length="1/10", friction="5%", stiffness="10%", preload="20%")


def at_the_bounds(source, c, near=NEAR):
    """Return a contact at the ends of bounds of two degrees, with its tangents turned along."""
    t, axes = source.choice([HALF_TURN, -HALF_TURN, Fraction(0)]), c.tangents
    cosine, sine = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    way = (1,) if c.dimension == 2 else source.choice([(1, 0), (0, 1), (Fraction(3, 5), "4/5")])
    way = [Fraction(x) for x in way]
    across = [dot(way, column) for column in zip(*axes, strict=True)]
    normal, first = (
        tuple(a * x + b * y + d * z for x, y, z in zip(c.normal, across, axes[0], strict=True))
        for a, b, d in ((cosine, sine, 0), (-sine * way[0], (cosine - 1) * way[0], 1))
    )
    point = [x + source.choice([-1, 1]) * near.length for x in c.point]
    numbers = [
        x * (1 + source.choice([-1, 1]) * share)
        for x, share in (
            (c.friction, near.friction),
            (c.stiffness, near.stiffness),
            (c.preload, near.preload),
        )
    ]
    return Contact(point, normal, *numbers, *([first] if c.dimension == 3 else []))


def random_contact(source, dimension):
    c = random_leaf(source)[0].contacts[0]
    if dimension == 3:
        c = next(iter(Grasp([c]).in_space()))
        c = Contact((*c.point[:2], source.randint(-1, 1)), c.normal, c.friction, 1, 1)
    return c


@pytest.mark.parametrize("dimension", [2, 3])
def test_forms_hold_all_contacts_within_bounds(dimension):
    source, unit, n = Random(dimension), 2**128, 3 * dimension - 3
    for _ in range(60):
        c = random_contact(source, dimension)
        motion = tuple(Fraction(source.randint(-9, 9), 3) for _ in range(n + 1))
        spring, slips = _Uncertain(c, NEAR).corner(motion)
        for _ in range(6):
            other = at_the_bounds(source, c)
            force = other.preload * motion[0] - other.stiffness * dot(
                other.normal_wrench, motion[1:]
            )
            moves = [dot(row, motion[1:]) for row in other.tangential_wrenches]
            for form, x in zip([spring, *slips], [force, *moves], strict=True):
                assert form.low <= x * unit <= form.high
        exact = _Uncertain(c, Bounds()).corner(motion)[0]
        assert exact.high - exact.low < 2**8


@pytest.mark.parametrize("dimension", [2, 3])
def test_contacts_within_bounds_do_at_least_what_is_counted(dimension):
    """The law itself, at random motions of a cell, against the bounds at its corners."""
    source, n, tight = Random(f"works {dimension}"), 3 * dimension - 3, 0
    for _ in range(200):
        c = random_contact(source, dimension)
        middle = [source.randint(-6, 6) for _ in range(n)]
        corners = [
            (
                Fraction(source.randint(0, 1)),
                *(x + Fraction(source.randint(-4, 4), 4) for x in middle),
            )
            for _ in range(source.choice([1, 2, 4]))
        ]
        virtual = tuple(Fraction(source.randint(-3, 3)) for _ in range(n))
        near = source.choice([NEAR, Bounds(degrees=2)])
        bounded = _Uncertain(c, near)
        counted = bounded.works(virtual, [bounded.corner(y) for y in corners])
        for _ in range(4):
            other = at_the_bounds(source, c, near)
            weights = [source.randint(0, 3) for _ in corners]
            motion = [dot(weights, column) for column in zip(*corners, strict=True)]
            spring = max(
                0,
                other.preload * motion[0] - other.stiffness * dot(other.normal_wrench, motion[1:]),
            )
            slip = [float(dot(row, motion[1:])) for row in other.tangential_wrenches]
            across = [float(dot(row, virtual)) for row in other.tangential_wrenches]
            size = math.hypot(*slip)
            rub = -math.hypot(*across)
            if size:
                rub = -sum(x * y for x, y in zip(slip, across, strict=True)) / size
            work = float(spring) * (
                float(dot(other.normal_wrench, virtual)) + float(other.friction) * rub
            )
            least = float(dot(weights, counted)) / 2**128
            assert work >= least - 1e-9 * (1 + abs(least))
            tight += spring > 0 and work < least + abs(least) / 4 + 1e-3
    assert tight > 8


def test_bounds_have_ends_and_forms_their_sizes():
    most = {"degrees": 45, "length": 10**9, "friction": "99/100", "preload": "99%"}
    assert Bounds(**most).friction == Fraction(99, 100)
    for name, most_of in most.items():
        past = Fraction(str(most_of).removesuffix("%")) + Fraction(1, 10**6)
        share = ", a share" * (name in ("friction", "preload"))
        with pytest.raises(GraspError, match=f"give a number from 0 to [0-9.]+{share}"):
            Bounds(**{name: f"{past}%" if name == "preload" else past})
        with pytest.raises(GraspError, match=f"{name} is "):
            Bounds(**{name: Fraction(-1, 2)})
    half = Bounds(degrees=3, length=1, friction="5%").times(Fraction(1, 2))
    assert half == Bounds(degrees="3/2", length="1/2", friction="1/40")
    assert str(half).startswith("normals within 1.5 degrees, points within 0.5, friction within")
    assert str(Bounds()) == "no change"
    assert 0 <= Bounds(degrees=45).angle - math.pi / 4 < 1e-6
    turned = _Uncertain(Contact([0, 0], [0, 1], 1), Bounds(degrees=2, friction="5%"))
    assert 0 <= turned.lost.low / 2**128 - (1 - math.cos(math.radians(2))) < 1e-6
    assert 0 <= turned.friction.low - 2**128 * Fraction(19, 20) + 2 < 4
    form = Affine(-3, (1, -2))
    assert (form.low, form.high, form.size) == (-6, 0, 6)


def random_form(source, parts=2):
    """Return a form whose numbers are single units of 2^-128, or whole."""
    unit = source.choice([1, 2**63 - 5, 2**128])
    centre, *row = (unit * source.randint(-3, 3) for _ in range(parts + 1))
    return Affine(centre, tuple(row), unit * source.randint(0, 2))


def ends(form):
    """Yield the numbers of a form without rest at the ends of all x, exact, in units."""
    for at in product((-1, 1), repeat=len(form.parts)):
        yield at, Fraction(form.centre + dot(at, form.parts))


@pytest.mark.parametrize("seed", range(5))
def test_forms_hold_sums_and_products_and_little_more(seed):
    """All numbers are at most the rest away from where the form has them, and some almost."""
    source = Random(f"forms {seed}")
    for _ in range(30):
        check_forms(source)


def check_forms(source):
    a, b = random_form(source), random_form(source)
    above, below = source.choice([-5, -1, 0, 3, 2**128]), source.choice([1, 3, 2**127 + 1])
    third = Fraction(source.randint(-4, 4), source.choice([1, 3]))

    def farthest(found, exact):
        """Return how far numbers are from the form without its rest."""
        pairs = zip(ends(found), ends(a), ends(b), strict=True)
        return max(
            abs(exact(x + i * a.rest, y + j * b.rest) - at)
            for ((_, at), (_, x), (_, y)) in pairs
            for i, j in product((-1, 1), repeat=2)
        )

    assert farthest(a.plus(b), lambda x, y: x + y) == a.plus(b).rest
    assert farthest(a.negative(), lambda x, y: -x) == a.rest
    scaled = a.scaled(above, below)
    assert 0 <= scaled.rest - farthest(scaled, lambda x, y: x * above / below) <= 4
    product_ = a.times(b)
    assert farthest(product_, lambda x, y: x * y / 2**128) <= product_.rest
    given = _form(3, third, {0: 2 * third, 2: Fraction(1, 2)})
    exact = (third, 2 * third, Fraction(0), Fraction(1, 2))
    lost = [x * 2**128 - y for x, y in zip(exact, (given.centre, *given.parts), strict=True)]
    assert max(lost) < 1
    assert given.rest == sum(x != 0 for x in lost)


def test_the_rest_of_a_product_is_reached():
    one = 2**128
    a, b = Affine(3 * one, (2 * one,), one), Affine(-one, (-2 * one,), 3 * one)
    assert a.times(b) == Affine(-3 * one, (-8 * one,), (1 * 1 + 3 * 3 + 3 * 5) * one)
    assert a.times(Affine(1, (0,), 0)) == Affine(3, (2,), 1)
    assert Affine(1, (1, 1)).times(Affine(1, (1, 1))) == Affine(0, (0, 0), 4)
    assert Affine(one, (one,), 1).scaled(-1, 2) == Affine(-one // 2, (-one // 2,), 3)


@pytest.mark.parametrize("sizes", [(), (0,), (1,), (3, 4), (2, 3), (2**128, 1), (5, 12, 84)])
def test_a_length_is_rounded_up(sizes):
    found, square = _length(sizes), sum(x * x for x in sizes)
    assert (found - 1) ** 2 <= square < found**2


@pytest.mark.parametrize(("low", "high"), [(-1, 1), (0, 1), (Fraction(1, 4), Fraction(1, 2))])
def test_halves_meet_in_the_middle(low, high):
    rest, middle = (Fraction(1), Fraction(1)), Fraction(low + high, 2)
    parts = list(halves([rest, (Fraction(low), Fraction(high)), rest], 1))
    assert parts == [[rest, (low, middle), rest], [rest, (middle, high), rest]]
    assert list(corners_of(parts[0])) == [(1, low, 1), (1, middle, 1)]


ONE = 2**128


def whole(vectors, unit=ONE):
    """Return forms without parts of vectors of integers."""
    return [[Affine(x * unit, ()) for x in v] for v in vectors]


@pytest.mark.parametrize(
    ("b", "slips", "most"),
    [
        ((1, 0), [(3, 4)], Fraction(3, 5)),
        ((-1, 0), [(3, 4)], Fraction(-3, 5)),
        ((1, 0), [(4, 3), (4, -3)], 1),
        ((0, 1), [(4, 3), (4, -3)], Fraction(3, 4)),
        ((-1, 0), [(4, 3), (4, -3)], Fraction(-4, 5)),
        ((-2, -3), [(5, 12), (9, -12)], Fraction(78, 25)),
        ((3, 4), [(0, 0)], 5),
        ((-3, 4), [(0, 0), (1, 0)], 5),
        ((-3, 4), [(2, 0), (-1, 0)], 5),
        ((-3, 4), [(2, 0), (0, 1), (0, -1)], 5),
    ],
)
def test_the_largest_work_of_a_cone_is_little_below_what_is_counted(b, slips, most):
    (b,), slips = whole([b]), whole(slips)
    assert 0 <= _largest(b, slips) - most * ONE < 2**40


def test_the_largest_work_of_slips_that_are_uncertain():
    (b,), ((away,),) = whole([(1, 3)]), whole([(0,)])
    slip = [Affine(10 * ONE, (ONE,)), Affine(0, (0,))]
    b = [Affine(x.centre, (0,)) for x in b]
    assert 0 <= _largest(b, [slip]) - Fraction(121, 81) * ONE < 2**40
    b = [x.negative() for x in b]
    assert 0 <= _largest(b, [slip]) - Fraction(-9, 11) * ONE < 2**40
    # In single units: the product that is 1 has to be divided by the cosine, too.
    b = [Affine(2, ()), away]
    assert _largest(b, whole([(1, 2), (1, -2)])) == 3


@pytest.mark.parametrize("unit", [1, ONE])
@pytest.mark.parametrize(
    ("b", "slips", "still", "turns"),
    [
        ((3, 4), [(4, 0)], 3, [0]),
        ((-2, 1), [(4, 3), (4, -3)], Fraction(-5, 4), [Fraction(3, 4), Fraction(-3, 4)]),
        ((2, 1), [(4, 3), (4, -3)], Fraction(35, 16), [Fraction(3, 4), Fraction(-3, 4)]),
        ((-5, -4), [(2, 1), (5, 0), (5, -1)], Fraction(-27, 8), [-1, 0, 1]),
        ((0, 4), [(3, 1), (3, -1), (6, 0)], Fraction(2, 3), [1, -1, 0]),
    ],
)
def test_turning_slips_do_what_is_counted(b, slips, still, turns, unit):
    """The formula in fractions; the middle slip is along the first axis, of length 4."""
    (b,) = whole([b], unit)
    found, sides = _turning(b, whole(slips))
    # Beside the formula: what v and t are rounded by, and the two roundings of b . v.
    length = math.isqrt(sum(x.centre**2 for x in b))
    least = math.ceil(still * unit - b[0].centre) + (length >> 90) + 1
    assert 0 <= found.rest - 2 - least <= 4 + (length >> 80)
    assert found.centre == b[0].centre
    for side, turn in zip(sides, turns, strict=True):
        assert side.low <= turn * unit <= side.high
        assert side.rest < 16


def test_uncertain_slips_turn_further():
    """Slips (96 +- 24, 35) and (96 +- 24, -35): of length 125 at most, 72 along at least."""
    (b,) = whole([(-2, 1)])
    slips = [[x._replace(rest=24 * ONE), y] for x, y in whole([(96, 35), (96, -35)])]
    found, _ = _turning(b, slips)
    tangent, uneven = Fraction(35, 72), Fraction(29, 96)
    assert 0 <= found.rest - (tangent**2 + tangent * uneven) * ONE < 2**48
    found, _ = _turning([b[0]._replace(rest=ONE), b[1]], slips)
    assert 0 <= found.rest - (1 + 3 * tangent**2 / 2 + tangent * uneven) * ONE < 2**48


def test_signs_are_read_to_the_last_unit():
    contact = _Uncertain(Contact((0, 0), (0, 1), "1/2"), Bounds())
    none = (0,) * contact.number
    slips = [Affine(ONE, none)]
    assert contact.works((0, -1, 0), [(Affine(1, none), slips)])[0] <= -1
    springs = [Affine(x, none) for x in (-1, 2 * ONE)]
    assert max(contact.works((0, 1, 0), [(e, slips) for e in springs])) <= 0
    # A slip of 0 in space: only the length is rounded, by a unit.
    contact = _Uncertain(Contact((0, 0, 0), (0, 0, 1), 1), Bounds())
    still, one = (Affine(x, (0,) * contact.number) for x in (0, ONE))
    assert contact.works((0, 1, -1, 0, 0, 0), [(one, [still, still])]) == [-2 * ONE - 1]


@pytest.mark.parametrize("small", [0, Fraction(1, 2**200)])
def test_without_friction_or_preload_no_force_is_at_rest(small):
    for values in ((small, 1, 1), (1, 1, small)):
        contact = _Uncertain(Contact((0, 0), (0, 1), *values), Bounds())
        assert contact.at_rest((Fraction(1, 2**128),)) is None
        assert contact.at_rest((Fraction(0),)) is not None


def test_slips_that_may_turn_too_far_have_no_linear_bound():
    (b,) = whole([(1, 1)])
    assert _turning(b, whole([(4, 4), (4, -4)])) is None
    assert _turning(b, whole([(-1, 0), (9, 0)])) is None
    assert _turning(b, whole([(2, 0), (-2, 0)])) is None
    assert _turning(b, whole([(1, 0)], 2**99)) is None
    assert _turning(b, [*whole([(2, 0)], 1), *whole([(4, 0)])]) is None
    assert _turning(b, whole([(100, 99), (100, -99)]))
    assert _turning(b, whole([(1, 0)], 2**100))


#: Virtual motion along tangents and normal; at corners spring force, its rest, and slips; works.
WORKS = [
    ((0, 1), [(2, 0, 1)], [2]),
    ((1, 1), [(2, 0, 1)], [1]),
    ((1, 1), [(2, 0, -1)], [3]),
    ((1, 1), [(2, 0, 0)], [1]),
    ((-1, 1), [(2, 0, 0)], [1]),
    ((1, 1), [(2, 0, 1), (4, 0, -1)], [1, 2]),
    ((-1, 1), [(2, 0, 1), (4, 0, -1)], [1, 2]),
    ((0, 1), [(1, 1, 1), (2, 0, 1)], [0, 2]),
    ((0, 1), [(2, 0, 1), (-1, 0, 1)], [0, 0]),
    ((0, -1), [(2, 0, 1), (-1, 0, 1)], [-2, 0]),
    ((0, -1), [(2, 0, 1), (0, 1, 1)], [-2, -1]),
    ((0, 1), [(2, 0, 1), (0, 1, 1)], [0, 0]),
    ((1, 0), [(-2, 0, 1), (-1, 1, 1)], [0, 0]),
    ((1, 0), [(-2, 0, -1), (-1, 2, -1)], [0, 0]),
    ((3, 4, 0), [(2, 0, 0, 0)], [-5]),
    ((-2, 1, 1), [(2, 0, 4, 3), (4, 0, 4, -3)], ["7/4", "29/4"]),
    ((-2, 1, 1), [(2, 1, 4, 3), (4, 1, 4, -3)], [-1, "9/2"]),
    ((-2, 1, 1), [(2, 1, 4, 3), (4, 0, 4, -3)], [-1, "55/8"]),
    ((0, 4, 1), [(2, 0, 3, 1), (4, 0, 3, -1), (6, 0, 6, 0)], ["-5/3", "11/3", 3]),
    ((0, 1, -1), [(2, 0, 4, 3), (-1, 0, 4, -3)], ["-11/4", 0]),
    ((0, 1, -1), [(2, 0, 4, 4), (6, 0, 4, -4)], [-3, -9]),
]


@pytest.mark.parametrize(("virtual", "corners", "works"), WORKS)
def test_the_work_of_a_contact_is_what_is_counted(virtual, corners, works):
    """At friction 1/2, worked out by hand; in the plane the tangent is opposite to the x axis."""
    n = len(virtual)
    normal = (*[0] * (n - 1), 1)
    contact = _Uncertain(Contact([0] * n, normal, "1/2"), Bounds())
    none = (0,) * contact.number
    forms = [
        (Affine(e * ONE, none, rest * ONE), [Affine(x * ONE, none) for x in slips])
        for e, rest, *slips in corners
    ]
    way = (-virtual[0], virtual[1], 0) if n == 2 else (*virtual, 0, 0, 0)
    found = contact.works(way, forms)
    spare = [Fraction(x) * ONE - y for x, y in zip(works, found, strict=True)]
    assert 0 <= min(spare) <= max(spare) < 2**46


@pytest.mark.parametrize(
    ("bounds", "motion", "virtual", "most"),
    [
        ({}, (0, 0, 0), (0, 1, 0), 1),
        ({}, (1, "1/2", 0), (0, 1, 0), 0),
        ({}, (1, "-1/2", 0), (2, 1, 0), 0),
        ({}, (-1, "-1/2", 0), (2, 1, 0), 4),
        ({"friction": "1/4"}, (0, 0, 0), (1, 1, 0), "3/8"),
        ({"friction": "1/4"}, (1, 0, 0), (1, 1, 0), "3/8"),
        ({"friction": "1/4"}, (-1, 0, 0), (1, 1, 0), "11/8"),
        ({"preload": "1/4"}, (0, 0, 0), (0, 1, 0), "3/4"),
        ({"preload": "1/4"}, (0, "-1", 0), (0, 1, 0), "11/4"),
        ({"stiffness": "1/4"}, (0, "1/4", 0), (0, 1, 0), "3/8"),
        ({"stiffness": "1/4"}, (0, -1, 0), (0, 1, 0), "5/2"),
        ({"length": "1/8"}, (0, 0, "1/2"), (0, 1, 0), "3/8"),
        ({"length": "1/8"}, (0, 0, 0), (0, 0, 1), "5/16"),
        ({"length": "1/8"}, (0, -1, 0), (0, 0, -1), "-33/16"),
        ({}, (1, 0, 0, 0, 0, 0), (1, 0, 1, 0, 0, 0), "1/2"),
        ({"friction": "1/4"}, (0, 1, 0, 0, 0, 0), (0, 1, 1, 0, 0, 0), "3/8"),
        ({"preload": "1/4"}, (0, 0, -1, 0, 0, 0), (0, 0, 1, 0, 0, 0), "11/4"),
        ({"stiffness": "1/4"}, (0, 0, -1, 0, 0, 0), (0, 0, 1, 0, 0, 0), "5/2"),
        ({"length": "1/8", "friction": "1/4"}, (1, 0, 0, 0, 0, 0), (1, 0, 1, 0, -1, 0), "11/64"),
        ({"length": "1/8", "friction": "1/4"}, (1, 0, 0, 0, 0, 0), (1, 0, 1, 0, 1, 0), "11/64"),
    ],
)
def test_a_leaf_holds_just_up_to_the_load_that_its_contact_bears(bounds, motion, virtual, most):
    """One contact at (1/2, 0) or (0, 0, 0), stiffness 2, preload 1, friction 1/2."""
    motion, n = [Fraction(x) for x in motion], len(virtual)
    place = (("1/2", 0), (0, 1)) if n == 3 else ((0, 0, 0), (0, 0, 1))
    grasp = Grasp([Contact(*place, "1/2", 2, 1)])
    for spare, holds in ((Fraction(1, 2**60), True), (Fraction(0), False)):
        # Of length 1 on the virtual motion, which is primitive.
        size = dot(virtual, virtual)
        load = tuple((spare - Fraction(most)) * x / size for x in virtual)
        box = Box(grasp, load, Bounds(**bounds), {"scales": ["1"] * n})
        ranges = [(Fraction(1), Fraction(1)), *((x, x) for x in motion)]
        assert box.holds(virtual, ranges) == holds


UNITS = [["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]]


@pytest.mark.parametrize(
    ("low", "high", "holds"), [(-1, -1, True), (-1, 1, False), (-1, 0, False), (1, 1, False)]
)
@pytest.mark.parametrize("form", [{"centre": ["0"] * 3, "axes": UNITS}, {"forces": []}])
def test_a_leaf_of_a_yes_pulls_back_at_all_corners(low, high, holds, form):
    """Without contacts, the load does work 1 on the virtual motion."""
    form = {"axes": [[]] * 3, "loads": UNITS} | form
    box = Box(Grasp(), (Fraction(1), Fraction(0), Fraction(0)), Bounds(), form)
    ranges = [(Fraction(low), Fraction(high)), *[(Fraction(-1), Fraction(1))] * 2]
    assert box.holds((1, 0, 0), ranges) == holds


@pytest.mark.parametrize(
    ("force", "bounds", "most"),
    [
        ("1/4", {}, "1/8"),
        ("5/8", {}, "1/2"),
        ("5/8", {"friction": "1e-9"}, None),
        ("5/8", {"preload": "1e-9"}, None),
        ("0.625000001", {}, None),
        ("-3/8", {}, "-1/2"),
        ("-0.375000001", {}, None),
        ("1/4", {"length": 1}, "1/8"),
    ],
)
def test_a_leaf_holds_just_up_to_what_friction_at_rest_bears(force, bounds, most):
    """One contact, the normal force 1, friction 1/2; the axis takes 1/8 off the force."""
    form = {"forces": [force], "axes": [["1/8"], ["0"], ["0"]], "loads": UNITS}
    y = [(Fraction(x), Fraction(x)) for x in (-1, 0, 0)]
    for spare, holds in ((Fraction(1, 2**60), most is not None), (Fraction(0), False)):
        wrench = (Fraction(most or 9) + spare, Fraction(0), Fraction(0))
        grasp = Grasp([Contact((0, 0), (0, 1), "1/2", 2, 1)])
        assert Box(grasp, wrench, Bounds(**bounds), form).holds((1, 0, 0), y) == holds


def test_faces_are_those_of_the_half_cube_or_the_cube():
    one, whole_, half = Fraction(1), (Fraction(-1), Fraction(1)), (Fraction(0), Fraction(1))
    wrench, scales = (one, one, one), {"scales": ["1", "2", "1/3"]}
    box = Box(Grasp(), wrench, Bounds(), scales)
    sides = [(k, (x, x)) for k in (1, 2, 3) for x in (-one, one)]
    assert list(box.faces()) == [
        (k, [side if j == k else half if j == 0 else whole_ for j in range(4)])
        for k, side in [(0, (one, one)), *sides]
    ]
    motion, load = box.motion((one, one, -one, one / 2))
    assert [Fraction(x, motion[0]) for x in motion] == [1, 1, -2, Fraction(1, 6)]
    assert (load, motion[0] > 0) == ((), True)
    axes = [["1", "0", "0"], ["0", "2", "0"], ["1", "0", "1/3"]]
    form = {"centre": ["1/2", "0", "0"], "axes": axes, "loads": UNITS}
    box = Box(Grasp(), wrench, Bounds(), form)
    assert list(box.faces()) == [
        (k - 1, [side if j == k - 1 else whole_ for j in range(3)]) for k, side in sides
    ]
    motion, load = box.motion((one, -one, one / 2))
    assert [Fraction(x, motion[0]) for x in motion] == [1, 2, -2, Fraction(1, 6)]
    assert [Fraction(x, load[0]) for x in load] == [1, -1, Fraction(1, 2)]
    assert load[0] < 0 < motion[0]


def test_directions_of_slips_in_a_cone_do_at_most_what_is_counted():
    source, one, tight = Random("cone"), 2**128, 0
    for _ in range(200):
        b = [source.uniform(-3, 3) for _ in range(2)]
        middle = [source.uniform(-2, 2) for _ in range(2)]
        slips = [[x + source.uniform(-0.5, 0.5) for x in middle] for _ in range(3)]
        forms, *rows = ([Affine(int(x * one), ()) for x in v] for v in (b, *slips))
        counted = _largest(forms, rows) / one
        for _ in range(20):
            weights = [source.choice([0, source.random()]) for _ in slips]
            slip = [dot(weights, column) for column in zip(*slips, strict=True)]
            if size := math.hypot(*slip):
                work = dot(slip, b) / size
                assert work <= counted + 1e-9
                tight += counted < min(work + 0.05, math.hypot(*b) - 0.05)
    assert tight > 300


@pytest.mark.parametrize("dimension", [2, 3])
def test_contacts_at_rest_do_at_least_what_is_counted(dimension):
    source, n = Random(f"rest {dimension}"), 3 * dimension - 3
    for _ in range(60):
        c = random_contact(source, dimension)
        bounded = _Uncertain(c, NEAR)
        least = c.friction * c.preload * Fraction(19, 20) * Fraction(4, 5)
        force = (least, *[Fraction(0)] * (dimension - 2))
        assert _Uncertain(c, Bounds()).at_rest((c.friction * c.preload, *force[1:])) is not None
        assert bounded.at_rest((least + Fraction(1, 10**6), *force[1:])) is None
        half = tuple(x / 2 for x in force)
        virtual = tuple(Fraction(source.randint(-3, 3)) for _ in range(n))
        counted = bounded.rest_work(virtual, bounded.at_rest(half)) / 2**128
        other = at_the_bounds(source, c)
        work = other.preload * dot(other.normal_wrench, virtual)
        pairs = zip(half, other.tangential_wrenches, strict=True)
        assert work + sum(x * dot(row, virtual) for x, row in pairs) >= counted - 1e-9


@pytest.mark.parametrize("reach", [Fraction(1, 50), Fraction(1, 2), Fraction(2)])
def test_directions_of_slips_that_turn_little_are_bounded_linearly(reach):
    """``u . b`` at the ends of all forms, for slips in the hull of the given."""
    source, one, bounded = Random(f"turning {reach}"), 2**128, 0

    def form(x, size):
        parts = [int(size * source.uniform(-1, 1) * one) for _ in range(2)]
        return Affine(int(x * one), tuple(parts), abs(int(size * one / 8)))

    def number(form, at):
        return (form.centre + sum(x * p for x, p in zip(at, form.parts, strict=False))) / one

    for _ in range(120):
        b = [form(source.uniform(-3, 3), source.choice([0, 0.1])) for _ in range(2)]
        angle, length = source.uniform(-4, 4), source.choice([1, 5])
        middle = [length * math.cos(angle), length * math.sin(angle)]
        slips = [
            [form(x + reach * source.uniform(-1, 1), reach / 10) for x in middle] for _ in range(4)
        ]
        found = _turning(b, slips)
        if found is None:
            assert reach > 1 / 50
            continue
        still, turns = found
        bounded += 1
        for _ in range(20):
            at, z = [source.choice([-1, 1]) for _ in range(2)], source.choice([-1, 1])
            weights = [source.random() for _ in slips]
            rows = [[number(x, at) + z * x.rest / one for x in slip] for slip in slips]
            slip = [dot(weights, column) for column in zip(*rows, strict=True)]
            work = sum(x * number(y, at) for x, y in zip(slip, b, strict=True)) / math.hypot(*slip)
            whole = sum(weights)
            least = [number(f, at) + f.rest / one for f in (still, *turns)]
            most = least[0] + dot(weights, least[1:]) / whole
            pairs = zip(slip, b, strict=True)
            work += sum(abs(x) * y.rest / one for x, y in pairs) / math.hypot(*slip)
            assert work <= most + 1e-9
            if reach < 1 / 2:
                assert most < work + 6 * reach
    assert bounded > 20


@pytest.mark.parametrize("motions", [[(1, 0, -1, 0)], [(1, 2, -1, 0), (1, -2, -1, 0)]])
def test_a_slip_of_unknown_sign_has_friction_both_ways(motions):
    bounded = _Uncertain(Contact((0, 0), (0, 1), "1/2", 1, 1), Bounds(degrees=2))
    corners = [bounded.corner(motion) for motion in motions]
    for way in (1, -1):
        assert max(bounded.works((way, 0, 0), corners)) < 0


@cache
def genuine_text(yes):
    """Return a proof for all within a degree and five per cent, and another load."""
    if yes:
        grasp, wrench = read_grasp("paper-three-contacts-preload-1"), (0, "1/2", 0)
    else:
        grasp = Grasp([Contact([0, -1], [0, 1], "1/2"), Contact([1, -1], [0, 1], "1/2")])
        wrench = (0, 1, 0)
    return solve(grasp, wrench).robust(degrees=1, friction="5%").certificate.text


def genuine(yes):
    return json.loads(genuine_text(yes))


def opposite(node):
    if isinstance(node, list):
        return [str(-Fraction(x)) for x in node]
    return {"cut": node["cut"], "children": [opposite(child) for child in node["children"]]}


def halved(k, d):
    return [{"cut": k, "children": d["faces"][:2]}]


def deep(cuts, leaf):
    node = leaf
    for _ in range(cuts):
        node = {"cut": 1, "children": [node, leaf]}
    return node


def flat(rows):
    return [rows[0], rows[0], rows[2]]


@pytest.mark.parametrize("yes", [True, False])
@pytest.mark.parametrize(
    "change",
    [
        lambda d: d | {"wrench": ["9", "9", "9"] if "axes" in d["box"] else ["0", "-1", "0"]},
        lambda d: d | {"bounds": {"degrees": "45", "friction": "1/2"}},
        lambda d: d | {"bounds": {"degrees": "1", "length": "9", "friction": "1/2"}},
        lambda d: d | {"bounds": {"preload": "0.99", "length": "3"}},
        lambda d: d | {"faces": [opposite(node) for node in d["faces"]]},
        lambda d: d | {"faces": [*d["faces"][1:], opposite(d["faces"][0])]},
        lambda d: d | {"faces": [["0", "0", "0"], *d["faces"][1:]]},
        lambda d: d | {"faces": [*d["faces"][:-1], {"cut": 0, "children": [["0", "0", "0"]] * 2}]},
    ],
)  # fmt: skip
def test_a_forged_proof_for_all_is_refused(yes, change):
    proof = genuine(yes)
    genuine_report = check(proof)
    assert genuine_report
    assert genuine_report.leaves == str(proof["faces"]).count("['")
    report = check(change(proof))
    assert not report
    assert "does not hold for all" in report.problem


@pytest.mark.parametrize(
    ("words", "yes", "change"),
    [
        ("do not span", True, lambda d: d["box"].update(axes=flat(d["box"]["axes"]))),
        ("above 0", False, lambda d: d["box"].update(scales=["0", "1", "1"])),
        ("expected 6", True, lambda d: d["faces"].pop()),
        ("expected 7", False, lambda d: d["faces"].pop()),
        ("does not fix", True, lambda d: d.update(faces=halved(0, d) * 6)),
        ("does not fix", True, lambda d: d.update(faces=halved(3, d) * 6)),
        ("does not fix", True, lambda d: d.update(faces=halved(True, d) * 6)),
        ("does not fix", True, lambda d: d["faces"].__setitem__(4, halved(True, d)[0])),
        ("does not fix", True, lambda d: d["faces"].__setitem__(0, halved(-1, d)[0])),
        ("does not fix", True, lambda d: d["faces"].__setitem__(4, halved("1", d)[0])),
        ("box", True, lambda d: d.update(box=5)),
        ("up to 200 times", True, lambda d: d["faces"].__setitem__(4, deep(201, d["faces"][4]))),
        ("unknown key", True, lambda d: d.update(certificate="not resisted")),
        ("unknown key", False, lambda d: d.update(certificate="resisted")),
        ("unknown key", True, lambda d: d.update(pyramid=4)),
        ("degrees is", True, lambda d: d.update(bounds={"degrees": "50"})),
        ("unknown key", True, lambda d: d.update(bounds={"mass": "1"})),
    ],
)  # fmt: skip
def test_what_is_no_proof_for_all_is_one_clear_error(words, yes, change):
    proof = genuine(yes)
    change(proof)
    with pytest.raises(InputError, match=words):
        check(proof)


def test_cells_are_cut_up_to_200_times():
    proof = genuine(True)
    proof["faces"][4] = deep(200, proof["faces"][4])
    assert check(proof)


def test_forces_at_rest_are_within_their_limits():
    pushed = solve(Grasp(SPATIAL), (0, 0, "1/10", 0, 0, 0)).robust(friction="5%")
    proof = pushed.certificate.to_dict()
    assert check(proof)
    for name in ("friction", "preload"):
        assert not check(proof | {"bounds": {name: "0.95"}})
    assert not check(proof | {"wrench": ["0", "0", "1", "0", "0", "0"]})
    forces = [str(Fraction(x) + 1) for x in proof["box"]["forces"]]
    assert not check(proof | {"box": proof["box"] | {"forces": forces}})


@pytest.mark.parametrize("flip", [[0], [1], [0, 1, 2], "zero"])
def test_loads_that_do_not_pull_back_prove_nothing(flip):
    proof = genuine(True)
    loads = proof["box"]["loads"]
    for k in range(3) if flip == "zero" else flip:
        loads[k] = ["0"] * 3 if flip == "zero" else [str(-Fraction(x)) for x in loads[k]]
    assert not check(proof)
