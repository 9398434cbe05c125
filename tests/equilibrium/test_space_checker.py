"""The checker of proofs in space: forged ones are refused, each for the reason that it has."""

import math
from collections import Counter
from fractions import Fraction
from itertools import product
from random import Random

import pytest
import sympy

from arrangement import InputError
from arrangement.numbers.exact import dot
from equilibrium import CertificateError, Grasp
from equilibrium.certificate.checker import proof_report
from equilibrium.certificate.contact_rule import broken_multipliers, within_room
from equilibrium.certificate.document import resisted_certificate
from equilibrium.certificate.enclosure import (
    BrokenLaw,
    Interval,
    _balance,
    felt_by,
    interval,
    total,
)
from equilibrium.certificate.law import law_rows
from equilibrium.certificate.leaf_rule import TreeQuestion
from equilibrium.certificate.reading import FORMS, Place, Split, read_enclosure, read_node
from equilibrium.certificate.tree import slip_states
from equilibrium.decide.solver import solve
from equilibrium.grasps.inputs.random import random_grasp, random_wrench
from equilibrium.model.contact import Contact, pyramid_edges
from equilibrium.model.solution import Enclosure, Leaf, Solution

F = Fraction
ENDS = [
    (F(1, 90), 0),
    (0, 1),
    (-2, 0),
    (0, F(-1, 9)),
    (3, 4),
    (F(4, 99), F(-3, 99)),
    (-5, 12),
    (-1, -1),
]
#: A normal and a tangent at a right angle.
AXES = [((0, 0, 1), (1, 0, 0)), ((F(3, 5), F(4, 5), 0), (0, 0, 1)), ((0, -1, 0), (0, 0, -1))]


def rows_of(contact):
    return contact.normal_wrench, *contact.tangential_wrenches


def plus(row, *terms):
    """Return a row plus factors times rows."""
    for factor, other in terms:
        row = [x + factor * y for x, y in zip(row, other, strict=True)]
    return tuple(map(F, row))


def question_of(contacts, load, edges=(), largest=None):
    return TreeQuestion(law_rows(contacts), load, FORMS[3], edges, largest)


def leaf_problem(question, leaf, states):
    return question.leaf_problem(leaf, Place("leaf", 0, (), states))


def states_of(edges):
    """Return every kind of state, with its slip directions; None where it has none of its own."""
    states = [(name, None) for name in ("undecided", "detached", "attached", "stick")]
    if not edges:
        pairs = [(u, v) for u in ENDS for v in ENDS if u[0] * v[1] > u[1] * v[0]]
        return states + [(pair, pair) for pair in pairs]
    sides = zip(edges, (*edges[1:], edges[0]), strict=True)
    across = [(d - b, a - c) for (a, b), (c, d) in sides]
    ends = [None]
    for one, two in zip(across, (*across[1:], across[0]), strict=True):
        ends += [(one,), (one, two)]
    split = Split("faces", (0,), [("", None)] * len(ends))
    parts = slip_states(split, {0: "attached"}, "", edges)
    return states + list(zip(parts, ends, strict=True))[1:]


def most(b, state, ends, edges):
    """Return the largest ``x . b``, for x between which friction goes against the slips."""
    if edges:
        slip = ends and [sum(x) for x in zip(*ends, strict=True)]
        sides = [slip and dot(edge, slip) for edge in edges]
        return (
            max(dot(edge, b) for edge, side in zip(edges, sides, strict=True) if side == max(sides))
            if ends
            else max(dot(edge, b) for edge in edges)
        )
    off = 0.0
    if ends:
        start, end, angle = (math.atan2(y, x) for x, y in (*ends, b))
        width, angle = (end - start) % math.tau, (angle - start) % math.tau
        off = 0 if angle < width + 1e-9 else min(angle - width, math.tau - angle)
    return math.hypot(*b) * math.cos(off)


def forged_leaf(source, edges, state, ends):
    """Return a leaf on three contacts, wrong at one place or at none, and whether it is right."""

    def number():
        return F(source.randint(-4, 4), source.choice((1, 1, 2, 3)))

    normal, tangent = source.choice(AXES)
    point, turn = [source.randint(-2, 2) for _ in range(3)], [number() for _ in range(3)]
    friction, k, q = source.choice((F(0), F(1, 2), F(2))), F(source.randint(1, 5), 3), F(1, 2)
    contact = Contact(point, normal, friction, k, q, tangent)
    rows, a = rows_of(contact), number()
    inside = [sum(x) for x in zip(*ends, strict=True)] if ends else (number(), 0)
    near, *_, far = source.sample(ends, len(ends)) * 2 if ends else [inside, inside]
    long, short = (F(sum(map(abs, end)) or 1) for end in (near, far))
    beside = [9 * x / long - y / short for x, y in zip(near, far, strict=True)]
    b = source.choice([(number(), number()), source.choice(ENDS), inside, *[beside] * 4, (0, 0)])
    push = plus([0] * 3, *zip((a, *b), (row[:3] for row in rows), strict=True))
    x, y, z = point
    u, v, w = turn
    motion = (*plus(push, (-1, (v * z - w * y, w * x - u * z, u * y - v * x))), *turn)
    assert [dot(row, motion) for row in rows] == [a, *b]
    pins, largest = source.choice([((0, 0), F(0))] * 2 + [((F(1, 2), -1), F(1, 3)), ((0, 3), F(1))])
    bound = F(float(a - friction * most(b, state, ends, edges))).limit_denominator(999)
    alpha = source.choice([bound, bound, 0, -1, 1]) + source.choice([0, 0, F(1, 10**5), -F(1, 9)])
    h = source.choice([(0, 0), (0, 0), source.choice(ENDS), (number(), number())])
    # One contact that sticks takes h away; one that is detached, or sticks on its side, alpha.
    up, other = (1 if a >= 0 else -1), F(source.randint(1, 5), 2)
    back = -1 if alpha > 0 else 1
    helpers = [
        Contact(point, [up * x for x in normal], 0, 1, 1, tangent),
        Contact(point, [back * x for x in normal], 1, other, F(1, 5), tangent),
    ]
    given = [
        [alpha, *h],
        [0, -h[0] - pins[0], -up * (h[1] + pins[1])],
        [abs(alpha) * k / other, 0, 0],
    ]
    known, room = (state, "stick", "detached"), (3 * b[0] + 4 * b[1]) / F(5)
    if source.random() < 0.5:
        side = plus([0] * 3, (F(3, 5), rows[1][:3]), (F(4, 5), rows[2][:3]))
        side = [x if room >= 0 else -x for x in side]
        # Its first tangent is the normal of the other, or its second one.
        (a1, a2, a3), (b1, b2, b3) = normal, side
        turned = (a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1)
        first = source.random() < 0.5
        helpers[1] = Contact(point, side, 0, other, F(1, 5), normal if first else turned)
        given[2], known = (
            [F(0), alpha * k * first, alpha * k * (not first)],
            (state, *["stick"] * 2),
        )
    if source.random() < 0.15:
        i, j = source.choice([(1, 0), (1, 1), (2, 0)])
        given[i][j] += F(1, 7)
    least = alpha * q + given[1][0] + given[2][0] / 5 - sum(map(abs, pins)) * largest
    size = source.choice([F(1), F(1), F(1, 9), F(0), F(-1, 9)]) - least
    square = dot(motion, motion)
    load = plus([0] * 6, (size / square if square else 0, motion))
    right = [
        alpha >= 0 or state not in ("undecided", "detached"),
        state == "detached" or alpha <= a - friction * most(b, state, ends, edges) + 1e-9,
        not any(h) or state == "stick" or bool(ends and all(dot(h, end) <= 0 for end in ends)),
        given[1][0] <= abs(a) and (known[2] == "detached" or given[2][0] <= abs(room)),
    ]
    rest, contacts = plus([0] * 6, *zip(pins, rows[1:], strict=True)), [contact, *helpers]
    for one, (first, *others) in zip(contacts, given, strict=True):
        row, *both = rows_of(one)
        rest = plus(rest, (-first * one.stiffness, row), *zip(others, both, strict=True))
    right += [not any(rest), dot(load, motion) + least > 0]
    order = source.sample(range(3), 3)
    multipliers = {j: tuple(given[i]) for j, i in enumerate(order) if i or any(given[i])}
    leaf = Leaf(motion, multipliers, {order.index(0): (F(0), *pins)} if any(pins) else {})
    question = question_of([contacts[i] for i in order], load, edges, largest)
    named = {j: known[i] for j, i in enumerate(order) if known[i] != "undecided"}
    return leaf_problem(question, leaf, named), right


@pytest.mark.parametrize("count", [0, 4, 6])
def test_a_leaf_holds_exactly_where_the_definition_says_so(count):
    source, edges = Random(count), pyramid_edges(count) if count else ()
    words = ("alpha must", "alpha is larger", "h ", "alpha is larger", "sum of", "work of")
    found, states = Counter(), states_of(edges)
    for i in range(300):
        state = source.choice(states[:4] if i % 2 else states[4:])
        problem, right = forged_leaf(source, edges, *state)
        assert bool(problem) == (not all(right)), (problem, right)
        assert not problem or any(
            word in problem for word, good in zip(words, right, strict=True) if not good
        )
        if sum(right) >= 5:
            found[right.index(False) if problem else -1] += 1
    assert min(found[k] for k in (-1, 0, 1, 2, 4, 5)) > 3, found


@pytest.mark.parametrize(
    ("given", "most", "words"),
    [
        ((0, 1, 0), "1/4", ""),
        ((0, 1, 0), "1/3", "work of"),
        ((0, -1, 0), "1/4", "the sum of"),
        ((0, 2, 0), "1/9", "the sum of"),
        ((1, 1, 0), "1/9", "the sum of"),
        ((0, 0, 1), "1/9", "the sum of"),
        ((0, 1, 0), None, "no largest displacement"),
    ],
)
def test_displacements_in_space_have_their_price(given, most, words):
    """A contact that sticks pulls along each axis in turn; what it pulls is given back."""
    for j in range(3):
        axis, tangent = (tuple(int(i == (j + k) % 3) for i in range(3)) for k in range(2))
        contact = Contact((0, 0, 0), axis, 0, F(1, 3), 0, tangent)
        load = plus([F(x, 3) for x in axis] + [0] * 3)
        motion = plus([*axis, 0, 0, 0])
        leaf = Leaf(motion, {0: (0, -1, 0)}, {0: tuple(map(F, given))})
        asked = question_of([contact], load, (), None if most is None else F(most))
        problem = leaf_problem(asked, leaf, {0: "stick"})
        assert words in problem
        assert bool(problem) == bool(words)


def test_bounds_have_no_gap_between_whole_numbers():
    """In the sector from (1/9, 0) to (0, 1/9), inside, beside both ends, and opposite to them."""
    sector = ((F(1, 9), F(0)), (F(0), F(1, 9)))
    cases = {(1, 1): 2**0.5, (1, -1): 1, (-1, 1): 1, (-1, -1): -1, (0, -1): 0, (0, 0): 0}
    for (b, largest), mu, room in product(cases.items(), (F(1, 2), F(1), F(3)), range(-4, 6)):
        assert within_room(room, b, mu, sector) == (room >= mu * largest)
    # Below 0 at the bound, -1 for (4, 3), and less than 1 in the square beyond it, 1/2 for (1, 1).
    assert within_room(-1, (-1, 0), F(5, 4), ((4, -3), (4, 3)))
    assert not within_room(-1, (-1, 0), F(1), ((1, -1), (1, 1)))
    for state in ("undecided", "detached"):
        assert broken_multipliers(state, -1, (0, 0), is_below=True)
    question = question_of(table((0, 0), friction=0, preload=0), plus(ALONG))
    assert not leaf_problem(question, Leaf(plus(ALONG), {}), {})
    assert leaf_problem(question, Leaf(plus(ASIDE), {}), {})


def test_no_coordinate_of_what_depends_on_the_motion_may_be_left():
    """Contacts that stick, and have but one force or torque on any motion."""
    units = [tuple(int(i == j) for j in range(3)) for i in range(3)]
    load = plus([1, 1, 1, 0, 0, 0])
    for j in range(3):
        normal, point, tangent = units[j], units[j - 2], units[j - 1]
        contact, *both = [
            Contact(p, normal, 0, 1, 0, tangent) for p in ((0, 0, 0), point, [-x for x in point])
        ]
        for contacts, rows in (([contact], [(0, 1, 0)]), (both, [(0, 1, 0), (0, -1, 0)])):
            states = dict.fromkeys(range(len(contacts)), "stick")
            for factor, words in ((0, ""), (1, "the sum of")):
                given = {i: plus([0] * 3, (factor, row)) for i, row in enumerate(rows)}
                asked = question_of(contacts, load), Leaf(load, given), states
                assert words in leaf_problem(*asked)
                assert bool(leaf_problem(*asked)) == bool(words)


#: Slips and frictions whose lengths are rational; the first is none.
SIZED = [(0, 0), (1, 0), (0, -2), (3, 4), (F(-3, 5), F(4, 5)), (-8, -6), (F(5, 13), F(-12, 13))]


@pytest.mark.parametrize("pyramid", [None, 4])
def test_an_equilibrium_holds_exactly_where_the_law_does(pyramid):
    """A contact at the origin whose friction goes one way, and a load that balances it."""
    source, found = Random(1), Counter()
    for _ in range(400):
        normal, tangent = source.choice(AXES)
        friction, q, up = F(source.randint(0, 3), 2), F(source.randint(0, 2)), source.randint(-1, 2)
        contact = Contact((0, 0, 0), normal, friction, 2, q, tangent)
        rows, slip, spring = rows_of(contact), source.choice(SIZED), max(F(0), q - 2 * up)
        limit, toward = friction * spring, source.choice([slip, *SIZED])
        size = F(sympy.sqrt(dot(slip, slip)))
        share = source.choice([1, 1, F(1, 2), F(11, 10), -1]) * limit
        forced = [-share * x / (F(sympy.sqrt(dot(toward, toward))) or 1) for x in toward]
        if pyramid:
            sides = source.choice([(1, 0), (0, -1), (F(1, 2), F(-1, 2)), (F(-1, 3), F(2, 3))])
            forced = [share * x for x in sides]
        # The disc and the square of edges along the tangents, by their gauges.
        reach = sum(map(abs, forced)) if pyramid else F(sympy.sqrt(dot(forced, forced)))
        way = max(map(abs, slip)) if pyramid else size
        right = [source.random() > 0.1, reach <= limit, dot(forced, slip) == -limit * way]
        force = (spring + (0 if right[0] else F(1, 9)), *forced)
        if not right[0]:
            right[1:] = [True, True]
        load = plus([0] * 6, *((-x, row) for x, row in zip(force, rows, strict=True)))
        right += [source.random() > 0.1]
        load = plus(load, (0 if right[3] else 1, rows[source.randrange(3)]))
        motion = plus([0] * 6, *zip((up, *slip), rows, strict=True))
        proof = resisted_certificate(Grasp([contact]), load, Solution(motion, (force,)), pyramid)
        report = proof.verify()
        words = ("its spring gives", "of at most", "while it slips by", "add up to")
        due = "" if all(right) else words[right.index(False)]
        assert bool(report) == (not due), report.problem
        assert due in report.problem, report.problem
        assert ("while it slips" in report.problem) == (due == words[2])
        assert due in ("", words[3]) or report.problem.startswith("contact 1: ")
        found[due] += 1
    assert min(found[due] for due in ("", *words)) > 10, found


def test_split_parts_are_sectors_between_directions():
    ends, leaf = ((1, 0), (-3, 4), (0, -1)), ("", None)

    def states(kind, directions, children, state, edges=()):
        split = Split(kind, (1,), [leaf] * children, directions)
        return slip_states(split, {0: "stick", 1: state} if state else {}, "tree", edges)

    cyclic = [(ends[0], ends[1]), (ends[1], ends[2]), (ends[2], ends[0])]
    assert states("directions", ends, 4, "attached") == ["stick", *cyclic]
    ninths = ((F(1, 9), F(1, 9)), (F(-1, 9), F(1, 9)), (0, F(-1, 9)))
    assert len(states("directions", ninths, 4, "attached")) == 4
    assert states("directions", ((0, 2),), 2, cyclic[0]) == [((1, 0), (0, 2)), ((0, 2), (-3, 4))]
    square = pyramid_edges(4)
    face = states("faces", (), 9, "attached", square)[2]
    for words, asked in [
        ("for round cones", ("directions", ends, 4, "attached", square)),
        ("faces are for pyramids", ("faces", (), 9, "attached")),
        ("have 9 children", ("faces", (), 8, "attached", square)),
        ("have 9 children", ("faces", (), 10, "attached", square)),
        ("contact 2 is undecided here", ("faces", (), 9, "", square)),
        ("is slip between .1, 1. and .-1, 1. here", ("faces", (), 9, face, square)),
        ("contact 2 is not attached", ("directions", ends, 4, "stick")),
        ("contact 2 is not attached", ("directions", ends, 4, "")),
        ("go round once", ("directions", ends[:2], 3, "attached")),
        ("go round once", ("directions", (*ends, *ends), 7, "attached")),
        ("go round once", ("directions", ends[::-1], 4, "attached")),
        ("go round once", ("directions", ((1, 0), (0, 1), (-1, 0)), 4, "attached")),
        ("go round once", ("directions", (ends[0], (0, 0), *ends[1:]), 5, "attached")),
        ("go round once", ("directions", ends[:1], 2, cyclic[0])),
        ("go round once", ("directions", ((-1, 1), (-2, 2)), 3, cyclic[0])),
        ("go round once", ("directions", ((-1, 1), (-2, 3)), 3, cyclic[0])),
        ("go round once", ("directions", ((0, -1),), 2, cyclic[0])),
    ]:
        with pytest.raises(CertificateError, match=words):
            states(*asked)


@pytest.mark.parametrize(("directions", "children"), [(0, 2), (1, 2), (2, 3), (4, 5)])
def test_split_by_directions_has_stick_and_sectors(directions, children):
    def node(children):
        return {"contact": 0, "directions": [[1, 0]] * directions, "children": [[]] * children}

    assert len(read_node(node(children), "tree", 1, FORMS[3]).children) == children
    for wrong in (children - 1, children + 1):
        with pytest.raises(InputError, match=f"expected {children}"):
            read_node(node(wrong), "tree", 1, FORMS[3])


@pytest.mark.parametrize(("dimension", "motion"), [(2, 3), (3, 6)])
def test_displacements_have_a_number_for_each_direction(dimension, motion):
    def leaf(size):
        used = {"1": ["1/2"] * size}
        return {"virtual_motion": [0] * motion, "multipliers": {"0": [3]}, "displacements": used}

    slips = (0,) * (dimension - 1)
    found = read_node(leaf(dimension), "tree", 2, FORMS[dimension])
    assert found == Leaf((0,) * motion, {0: (3, *slips)}, {1: (HALF,) * dimension})
    for wrong in (dimension - 1, dimension + 1):
        with pytest.raises(InputError, match=f"has {wrong} entries; expected {dimension}"):
            read_node(leaf(wrong), "tree", 2, FORMS[dimension])


HALF, WIDE, NARROW, TINY = F(1, 2), F(1, 8), F(1, 1000), F(1, 2**192)


def table(*points, friction=HALF, preload=1):
    """Return contacts under a plate, at points with z = 0: they feel it move up and tilt."""
    return [Contact((*p, 0), (0, 0, 1), friction, 1, preload, (1, 0, 0)) for p in points]


FOUR = table((1, 0), (-1, 0), (0, 1), (0, -1))
ALONG, ASIDE, UP, TILT, TIP, SPIN = (tuple(int(i == j) for j in range(6)) for i in range(6))
#: What a plate on contacts that stick may do; and friction forces that it takes.
BASIS, PILLARS = (UP, TILT, TIP), ((0, 0), (0, 1), (1, 1))
STICK = (0, 0)


def enclosed(
    contacts=FOUR,
    wrench=(0, 0, -4, 0, 0, 0),
    friction=(STICK,) * 4,
    basis=BASIS,
    pillars=PILLARS,
    radius=WIDE,
    idle=(),
    shift=(0, 0),
    part=1,
    most=None,
):
    """Return a certificate around the solution of the linear equations of contacts that stick.

    Args:
        part: of the inverse of the equations, to be given in its place.
        shift: a coordinate of the centre, and how far it is from the solution there.
    """
    matrix, value = sympy.zeros(6, 6), sympy.Matrix(wrench)
    columns = [plus(motion) for motion in basis]
    for contact, share in zip(contacts, friction, strict=True):
        if not contact.friction:
            share = STICK
        if isinstance(share, tuple):
            normal, *tangents = rows_of(contact)
            force = plus(
                normal, *((contact.friction * x, t) for x, t in zip(share, tangents, strict=True))
            )
            value += contact.preload * sympy.Matrix(force)
            for j, motion in enumerate(columns):
                matrix[:, j] -= contact.stiffness * dot(normal, motion) * sympy.Matrix(force)
    for j, (i, k) in enumerate(pillars, len(columns)):
        matrix[:, j] += sympy.Matrix(contacts[i].tangential_wrenches[k])
    for *motion, x in idle:
        value -= x * sympy.Matrix(motion)
        for j, column in enumerate(columns):
            matrix[:, j] += dot(motion, column) * sympy.Matrix(motion)
    inverse = matrix.inv()
    centre = [F(x) for x in -inverse * value]
    centre[shift[0]] += shift[1]
    states = {"detached": None, "slip": ()}
    enclosure = Enclosure(
        tuple(columns),
        tuple(states[x] if isinstance(x, str) else tuple(map(F, x)) for x in friction),
        pillars,
        tuple(centre),
        (F(radius),) * 6 if isinstance(radius, (int, F)) else radius,
        tuple(tuple(F(part * x) for x in inverse.row(j)) for j in range(6)),
        tuple(plus(row) for row in idle),
    )
    found = Solution((), (), enclosure)
    return resisted_certificate(
        Grasp(contacts), plus(wrench), found, max_displacement=most
    ).verify()


#: Two contacts, and the turn about their line that neither feels.
ON_TWO = {
    "contacts": table((1, 0), (-1, 0)),
    "friction": (STICK,) * 2,
    "wrench": (0, 0, -2, 0, 0, 0),
}
#: Four contacts without friction, and motions along the table that none of them feels.
ON_ICE = {
    "contacts": table((1, 0), (-1, 0), (0, 1), (0, -1), friction=0),
    "friction": ("slip",) * 4,
    "basis": (*BASIS, ALONG, ASIDE, SPIN),
    "pillars": (),
}
TURN, PUSHED = (*TILT, 0), (*[NARROW] * 3, *[WIDE] * 3)
MOVED = (*[WIDE] * 3, *[NARROW] * 3)
VALID = {
    "four contacts stick": {},
    "under a load": {
        "wrench": (F(1, 16), F(1, 18), -3, F(1, 3), F(-1, 3), F(1, 14)),
        "radius": F(1, 20),
    },
    "with friction at its limit": {
        "friction": ((F(3, 5), F(4, 5)), *[STICK] * 3),
        "wrench": (F(-3, 10), F(-2, 5), -4, 0, 0, F(-2, 5)),
        "pillars": ((1, 0), (1, 1), (2, 0)),
    },
    "one is detached, at one end just so": {
        "contacts": [*FOUR[:3], *table((0, -1), preload=0)],
        "friction": (*[STICK] * 3, "detached"),
        "wrench": (0, 0, F(-13, 4), F(-5, 4), 0, 0),
    },
    "two and their line": {**ON_TWO, "idle": (TURN,)},
    "four on ice": {**ON_ICE, "idle": ((*ALONG, 0), (*ASIDE, 0), (*SPIN, 0))},
    "an end just beside the solution": {"shift": (0, WIDE - TINY)},
    "an end just beside the whole step": {"shift": (0, WIDE - 5 * TINY), "part": F(1, 2)},
    "up to the largest displacement": {"most": F(1, 4)},
    "friction up to its limit": {"wrench": (0, F(-1, 4), -4, 0, 0, F(1, 4))},
}
SHORT = "contact 1 has a friction above its limit"
OUT = "mapped into itself in coordinate 1"
FORGED = [
    (OUT, {"part": 0}),
    ("contact 1: its point may move", {"most": F(1, 4) - TINY / 2}),
    ("contact 1: its point may move", {"most": F(0)}),
    (OUT, {"shift": (0, WIDE)}),
    (OUT, {"shift": (0, -WIDE)}),
    (OUT, {"shift": (0, F(9, 64)), "part": F(1, 2)}),
    (OUT, {"shift": (0, F(-9, 64)), "part": F(1, 2)}),
    ("radius", {"radius": 0}),
    ("radius", {"radius": (*[WIDE] * 5, F(0))}),
    (
        "contact 1 is not attached",
        {"wrench": (0, 0, -2, 0, F(-11, 10), 0), "shift": (0, F(-1, 10))},
    ),
    (
        "contact 3 is not attached",
        {"wrench": (0, 0, -2, F(11, 10), 0, 0), "shift": (0, F(-1, 10)), "radius": MOVED},
    ),
    ("contact 1 sticks, and has a friction above", {"friction": ((1, F(1, 99)), *[STICK] * 3)}),
    (
        "contact 2 sticks, and has a friction above",
        {"friction": (STICK, (0, F(-9, 8)), *[STICK] * 2)},
    ),
    (SHORT, {"wrench": (F(-11, 20), 0, -4, 0, 0, 0), "radius": PUSHED, "shift": (3, F(-1, 10))}),
    (SHORT, {"wrench": (F(-27, 50), 0, -4, 0, 0, 0), "radius": MOVED, "shift": (0, F(-1, 10))}),
    (
        "contact 1 sticks, and a motion of the basis moves it",
        {"basis": (UP, plus(TILT, (1, ALONG)), TIP)},
    ),
    (
        "contact 1 sticks, and a motion of the basis moves it",
        {"basis": (UP, TILT, plus(TIP, (1, ASIDE)))},
    ),
    (
        "contact 4 is not detached",
        {
            "friction": (*[STICK] * 3, "detached"),
            "wrench": (0, 0, F(-39, 20), F(-19, 20), 0, 0),
            "shift": (0, F(1, 10)),
            "radius": MOVED,
        },
    ),
    ("contact 4 does not slip", {"friction": (*[STICK] * 3, "slip")}),
    (
        "contact 4 does not slip",
        {
            "contacts": [*FOUR[:3], Contact((0, -1, 1), (0, 0, 1), 1, 1, 1, (1, 0, 0))],
            "friction": (*[STICK] * 3, "slip"),
            "wrench": (0, 0, F(-47, 16), F(-15, 16), 0, 0),
        },
    ),
    (
        "contact 4 is a pillar and does not stick",
        {"pillars": (*PILLARS[:2], (3, 0)), "friction": (*[STICK] * 3, "slip")},
    ),
    ("a null-space motion", {**ON_TWO, "idle": (TURN,), "wrench": (0, 0, -2, F(1, 9), 0, 0)}),
    ("a null-space motion", {**ON_TWO, "idle": ((*TILT[:4], 1, 0, 0),)}),
    (
        "a null-space motion",
        {**ON_ICE, "idle": ((*ALONG, 0), (*ASIDE, 0), (*plus(TIP, (1, SPIN)), 0))},
    ),
]


@pytest.mark.parametrize("name", VALID)
def test_enclosures_of_contacts_that_stick_hold(name):
    assert not enclosed(**VALID[name]).problem


@pytest.mark.parametrize(("words", "change"), FORGED)
def test_forged_enclosures_are_refused_for_their_fault(words, change):
    assert words in enclosed(**change).problem


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"pillars": [[2, 0], [2, 1], [2, 2]]}, r"pillars\[2\] is 2; there are 0 to 1"),
        ({"pillars": [[3, 0], [2, 1], [2, 0]]}, r"pillars\[0\] is 3; there are 0 to 2"),
        ({"pillars": [[2, 0], [2, 1], [0, 0, 0]]}, r"pillars\[2\] has 3 entries; expected 2"),
        ({"pillars": [[2, 0], [2, 1]]}, "pillars has 2 entries; expected 3"),
        ({"friction": ["slip"] * 2}, "friction has 2 entries; expected 3"),
        ({"friction": ["slip", "slip", [1]]}, r"friction\[2\] has 1 entries; expected 2"),
        ({"friction": ["slip", "slip", [1, 2, 3]]}, r"friction\[2\] has 3 entries; expected 2"),
        ({"centre": [0] * 5}, "centre has 5 entries; expected 6"),
        ({"radius": [0] * 7}, "radius has 7 entries; expected 6"),
        ({"inverse": [[0] * 6] * 5}, "inverse has 5 entries; expected 6"),
        ({"inverse": [[0] * 5] * 6}, r"inverse\[0\] has 5 entries; expected 6"),
        ({"basis": [[0] * 7] * 3}, r"basis\[0\] has 7 entries; expected 6"),
        ({"idle": [[0] * 6]}, r"idle\[0\] has 6 entries; expected 7"),
    ],
)
def test_an_enclosure_of_another_size_is_one_clear_error(change, words):
    given = {
        "basis": [[0] * 6] * 3,
        "friction": ["detached", "slip", [0, "1/2"]],
        "pillars": [[2, 0], [2, 1], [0, 0]],
        "centre": [0] * 6,
        "radius": [1] * 6,
        "inverse": [[0] * 6] * 6,
        "idle": [[0] * 7],
    }
    found = read_enclosure(given, 3, FORMS[3])
    assert (found.friction, found.pillars) == ((None, (), (0, HALF)), ((2, 0), (2, 1), (0, 0)))
    with pytest.raises(InputError, match=words):
        read_enclosure({**given, **change}, 3, FORMS[3])


@pytest.mark.parametrize(("state", "up", "words"), [
    (STICK, (0, 1), "is not attached"), (None, (-1, 0), "is not detached"),
])  # fmt: skip
def test_a_spring_that_may_be_wrong_by_one_unit_is_refused(state, up, words):
    zero, row = Interval(0, 0), (F(0),) * 6
    given = Enclosure((plus(UP),), (state,), (), row, row, ())
    felt = felt_by(Grasp(table((0, 0), preload=0)), given.basis)
    _balance(felt, row, given, [zero] * 6, None, 6)
    box = [Interval(*up), *[zero] * 5]
    with pytest.raises(BrokenLaw, match=words):
        _balance(felt, row, given, box, None, 6)


def test_intervals_contain_exact_results_tightly():
    source, one = Random(1), 1 << 192
    ends = [0, 1, -1, one, -one, one + 1, *(source.randint(-5 * one, 5 * one) for _ in range(6))]
    intervals = [Interval(low, high) for low in ends for high in ends if low <= high]

    def fits(found, results):
        low, high = min(results) * one, max(results) * one
        assert found == (math.floor(low), math.ceil(high))

    for x in intervals:
        given = [F(end, one) for end in x]
        fits(x.negative(), [-end for end in given])
        fits(x.square(), [*(end**2 for end in given), *([0] if x.low < 0 < x.high else [])])
        if x.low > 0:
            root = x.inverse_root()
            for end, near, outside in ((x.high, root.low, 1), (x.low, root.high, -1)):
                assert 0 <= outside * (F(one, end) - F(near, one) ** 2) <= F(near, 2**150)
        y = source.choice(intervals)
        others = [F(end, one) for end in y]
        fits(x.times(y), [a * b for a in given for b in others])
        fits(x.plus(y), [a + b for a, b in zip(given, others, strict=True)])
        assert total([x, y, x]) == x.plus(y).plus(x)
    for number in (F(1, 3), F(-1, 3), 2, F(5, 4)):
        fits(interval(number), [number])


def leaves_of(node):
    """Yield the leaves of a tree that a search hands over."""
    if isinstance(node, Leaf):
        yield node
    elif isinstance(node, (dict, list)):
        for child in node.values() if isinstance(node, dict) else node:
            yield from leaves_of(child)


def with_leaf(node, old, new):
    """Return a tree with another leaf in place of one."""
    if node is old:
        return new
    if isinstance(node, dict):
        return {key: with_leaf(child, old, new) for key, child in node.items()}
    return [with_leaf(child, old, new) for child in node] if isinstance(node, list) else node


def test_leaves_handed_over_are_checked_as_those_of_files():
    grasp = random_grasp(4, 1, dimension=3)
    wrench = next(
        w
        for w in (random_wrench(seed, dimension=3, bound=1) for seed in range(40))
        if solve(grasp, w).verdict == "not resisted" and solve(grasp, w).verify().leaves > 3
    )
    verdict, refused = solve(grasp, wrench), 0
    assert proof_report(verdict.case, verdict.tree)
    for leaf in leaves_of(verdict.tree):
        for i, (alpha, *h) in leaf.multipliers.items():
            others = {j: row for j, row in leaf.multipliers.items() if j != i}
            zero = {**others, i: (F(0), F(0), F(0))}
            trees = (
                with_leaf(verdict.tree, leaf, Leaf(leaf.motion, rows)) for rows in (others, zero)
            )
            omitted, counted = (proof_report(verdict.case, tree) for tree in trees)
            assert omitted.problem.partition(":")[0] == counted.problem.partition(":")[0]
            assert not omitted
            wrong = Leaf(leaf.motion, {**leaf.multipliers, i: (alpha + 1, *h)})
            assert not proof_report(verdict.case, with_leaf(verdict.tree, leaf, wrong))
            refused += 1
    assert refused > 10
