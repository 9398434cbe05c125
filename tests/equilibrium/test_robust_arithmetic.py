"""The arithmetic of proofs within bounds, compared with fractions: forms, contacts, slips."""

import math
from fractions import Fraction
from itertools import product
from random import Random

import pytest

from arrangement.numbers.exact import dot
from equilibrium import Contact, Grasp, GraspError
from equilibrium.certificate.uncertain import (
    Affine,
    Bounds,
    Uncertain,
    _form,
    _largest,
    _length,
    _turning,
)

from .test_checker import random_leaf

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
        spring, slips = Uncertain(c, NEAR).corner(motion)
        for _ in range(6):
            other = at_the_bounds(source, c)
            force = other.preload * motion[0] - other.stiffness * dot(
                other.normal_wrench, motion[1:]
            )
            moves = [dot(row, motion[1:]) for row in other.tangential_wrenches]
            for form, x in zip([spring, *slips], [force, *moves], strict=True):
                assert form.low <= x * unit <= form.high
        exact = Uncertain(c, Bounds()).corner(motion)[0]
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
        bounded = Uncertain(c, near)
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
    turned = Uncertain(Contact([0, 0], [0, 1], 1), Bounds(degrees=2, friction="5%"))
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
    contact = Uncertain(Contact((0, 0), (0, 1), "1/2"), Bounds())
    none = (0,) * contact.number
    slips = [Affine(ONE, none)]
    assert contact.works((0, -1, 0), [(Affine(1, none), slips)])[0] <= -1
    springs = [Affine(x, none) for x in (-1, 2 * ONE)]
    assert max(contact.works((0, 1, 0), [(e, slips) for e in springs])) <= 0
    # A slip of 0 in space: only the length is rounded, by a unit.
    contact = Uncertain(Contact((0, 0, 0), (0, 0, 1), 1), Bounds())
    still, one = (Affine(x, (0,) * contact.number) for x in (0, ONE))
    assert contact.works((0, 1, -1, 0, 0, 0), [(one, [still, still])]) == [-2 * ONE - 1]


@pytest.mark.parametrize("small", [0, Fraction(1, 2**200)])
def test_without_friction_or_preload_no_force_is_at_rest(small):
    for values in ((small, 1, 1), (1, 1, small)):
        contact = Uncertain(Contact((0, 0), (0, 1), *values), Bounds())
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
    contact = Uncertain(Contact([0] * n, normal, "1/2"), Bounds())
    none = (0,) * contact.number
    forms = [
        (Affine(e * ONE, none, rest * ONE), [Affine(x * ONE, none) for x in slips])
        for e, rest, *slips in corners
    ]
    way = (-virtual[0], virtual[1], 0) if n == 2 else (*virtual, 0, 0, 0)
    found = contact.works(way, forms)
    spare = [Fraction(x) * ONE - y for x, y in zip(works, found, strict=True)]
    assert 0 <= min(spare) <= max(spare) < 2**46


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
        bounded = Uncertain(c, NEAR)
        least = c.friction * c.preload * Fraction(19, 20) * Fraction(4, 5)
        force = (least, *[Fraction(0)] * (dimension - 2))
        assert Uncertain(c, Bounds()).at_rest((c.friction * c.preload, *force[1:])) is not None
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
    bounded = Uncertain(Contact((0, 0), (0, 1), "1/2", 1, 1), Bounds(degrees=2))
    corners = [bounded.corner(motion) for motion in motions]
    for way in (1, -1):
        assert max(bounded.works((way, 0, 0), corners)) < 0
