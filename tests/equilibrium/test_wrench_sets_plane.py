from fractions import Fraction
from itertools import pairwise

import pytest
from hypothesis import assume, given, strategies as st

from arrangement.errors import InputError, OutOfReachError
from arrangement.numbers import budget
from arrangement.numbers.linear.intervals import holds, remainder, union
from arrangement.numbers.linear.polyhedron import from_conditions
from equilibrium import Assembly, Contact, Grasp, GraspError, ResistedSet, read_grasp, solve
from equilibrium.core.contact_rows import any_friction_does
from equilibrium.decide.solver import Solver
from equilibrium.model.effort import Effort
from equilibrium.wrench_sets.friction import least_friction
from equilibrium.wrench_sets.line import margin, sufficient_preloads
from equilibrium.wrench_sets.outline import outline_of
from equilibrium.wrench_sets.search_map import binary_search, compare, search_map
from equilibrium.wrench_sets.slice import FORCES, polygon_cycle, resisted_region, sectors

from .strategies import directions, loads as wrenches, small, wide_grasps as grasps

TINY = Fraction(1, 10**30)
numbers = st.fractions(-4, 4, max_denominator=3)
planar = st.tuples(numbers, numbers)


def square(x, y, side=1):
    rows = [(1, 0, -x), (-1, 0, x + side), (0, 1, -y), (0, -1, y + side)]
    return from_conditions(rows, [], 2)


def ends(segments):
    return {(s.start, s.end) for s in segments}


@pytest.mark.parametrize(
    ("squares", "corners"),
    [
        ([square(0, 0), square(1, 0)], "00 20 21 01"),
        ([square(0, 0, 2), square(1, 1, 2)], "00 20 21 31 33 13 12 02"),
    ],
)
def test_squares_that_meet_have_one_border(squares, corners):
    cycle = [(int(x), int(y)) for x, y in corners.split()]
    found = ends(outline_of(squares).border)
    assert found == set(zip(cycle, [*cycle[1:], cycle[0]], strict=True))


def test_four_quadrants_have_no_border():
    quadrants = [from_conditions([(a, 0, 0), (0, b, 0)], [], 2) for a in (1, -1) for b in (1, -1)]
    assert outline_of(quadrants).border == ()
    assert len(outline_of(quadrants[:3]).border) == 2


def test_flat_parts_stick_out_and_points_stand_alone():
    whisker = from_conditions([(1, 0, 0), (-1, 0, 5)], [(0, 1, 0)], 2)
    inner = from_conditions([], [(4, 0, -1), (4, 0, -1), (0, 4, -1)], 2)
    alone = from_conditions([], [(1, 0, 3), (0, 1, 3)], 2)
    outline = outline_of([square(0, 0), whisker, inner, alone])
    assert ends(outline.whiskers) in ({((1, 0), (5, 0))}, {((5, 0), (1, 0))})
    assert outline.points == ((-3, -3),)


def test_a_contact_without_friction_resists_a_ray():
    grasp = Grasp([Contact((0, 0), (0, 1), 0)])
    region = resisted_region(grasp)
    assert region.outline.border == ()
    (whisker,) = region.outline.whiskers
    assert {whisker.start, whisker.end} == {(0, 0), None}
    (sector,) = region.unlimited
    assert sector.start == sector.end == (0, -1)
    assert resisted_region(Grasp()).outline.points == ((0, 0),)


@given(grasps(), st.sampled_from([FORCES, ((1, 0, 2), (0, 1, -1))]), wrenches, planar)
def test_membership_is_the_verdict_of_the_solver(grasp, spans, origin, point):
    a, b = point
    wrench = [o + a * u + b * v for o, u, v in zip(origin, *spans, strict=True)]
    region = resisted_region(grasp, spans, origin)
    assert region.contains(point) == solve(grasp, wrench).stable
    assert bool(region.states_at(point)) == region.contains(point)


@pytest.mark.slow
@given(grasps(least=2))
def test_resistance_ends_at_the_border_and_nowhere_else(grasp):
    region = resisted_region(grasp)
    for segment in region.outline.border:
        middle = _middle(segment)
        outside = tuple(x - TINY * n for x, n in zip(middle, segment.normal, strict=True))
        inside = tuple(x + TINY * n for x, n in zip(middle, segment.normal, strict=True))
        assert solve(grasp, (*middle, 0)).stable
        assert solve(grasp, (*inside, 0)).stable
        assert not solve(grasp, (*outside, 0)).stable


@given(grasps(least=2), planar, planar.filter(any))
def test_every_end_along_a_line_lies_on_the_outline(grasp, start, direction):
    """Between the outline's parts the region does not change, seen along any line."""
    region = resisted_region(grasp)
    parts = [p.polyhedron.along(start, direction) for p in region.polygons]
    ends = {x for part in union(p for p in parts if p) for x in part if x is not None}
    assume(ends)
    for end in ends:
        point = tuple(a + end * u for a, u in zip(start, direction, strict=True))
        assert _on_outline(region.outline, point)


def test_sectors_across_the_first_axis_and_open_ends():
    (right,) = sectors([(1, 1), (1, -1)], lambda u: u[0] > abs(u[1]))
    assert (right.start, right.end) == ((1, -1), (1, 1))
    assert not right.has_start
    assert not right.has_end
    (whole,) = sectors([], lambda u: True)
    assert whole.whole
    assert sectors([(2, 1)], lambda u: False) == ()
    (single,) = sectors([(2, 1)], lambda u: u == (2, 1))
    assert single.start == single.end == (2, 1)


bounded = st.tuples(small, small).map(lambda p: (Fraction(min(p)), Fraction(max(p))))
intervals = st.one_of(
    bounded, bounded.map(lambda p: (p[0], None)), bounded.map(lambda p: (None, p[1]))
)


@given(st.lists(intervals, max_size=5), st.fractions(-3, 3, max_denominator=2))
def test_union_keeps_membership_and_is_disjoint(parts, value):
    merged = union(parts)
    assert holds(merged, value) == holds(parts, value)
    for (_, high), (low, _) in pairwise(merged):
        assert high < low


@given(intervals, st.lists(intervals, max_size=4), st.fractions(-3, 3, max_denominator=7))
def test_remainder_and_removed_parts_make_the_whole(whole, removed, value):
    value += Fraction(1, 1009)  # not an end
    expected = holds([whole], value) and not holds(removed, value)
    assert holds(remainder(whole, removed), value) == expected


def _middle(segment):
    """A point of the segment that is not an end, and generic."""
    u, n = segment.direction, segment.normal
    if segment.start is not None and segment.end is not None:
        u = [b - a for a, b in zip(segment.start, segment.end, strict=True)]
    foot = [Fraction(-segment.constant * x, sum(y * y for y in n)) for x in n]
    start = segment.start or segment.end or foot
    side = -1 if segment.start is None and segment.end is not None else 1
    return tuple(a + Fraction(side, 97) * x for a, x in zip(start, u, strict=True))


def _on_outline(outline, point):
    if point in outline.points:
        return True
    return any(_on(segment, point) for segment in (*outline.border, *outline.whiskers))


def _on(segment, point):
    n, u = segment.normal, segment.direction
    if n[0] * point[0] + n[1] * point[1] + segment.constant != 0:
        return False
    place = u[0] * point[0] + u[1] * point[1]
    after = segment.start is None or place >= u[0] * segment.start[0] + u[1] * segment.start[1]
    before = segment.end is None or place <= u[0] * segment.end[0] + u[1] * segment.end[1]
    return after and before


THREE = "paper-three-contacts-preload-1"
FOUR = "paper-four-contacts-preload-1"


def times(wrench, factor):
    return [factor * x for x in wrench]


def gap_grasp():
    return Grasp(
        [
            Contact((0, 1), (1, 0), 1, 1, 1),
            Contact((-1, 1), (0, 1), 1, 1, 1),
            Contact((-1, 0), (0, -1), 0, 1, 1),
        ]
    )


def test_margins_of_the_paper():
    assert margin(read_grasp(THREE), (0, "1/2", 0)).around == (0, 2)
    assert margin(read_grasp(THREE), (0, -3, 0)).around == (0, None)
    assert margin(read_grasp(FOUR), (0, -2, 0)).around == (0, 1)
    beyond = margin(read_grasp(FOUR), (0, 4, 0))
    assert not beyond.resisted
    assert beyond.around is None
    assert beyond.nearest == Fraction(1, 2)


def test_the_margin_stays_on_its_side_of_a_gap():
    assert margin(gap_grasp(), (-1, 0, 0)).around == (0, 1)
    assert margin(gap_grasp(), (-4, 0, 0)).around == (Fraction(1, 2), None)
    assert margin(gap_grasp(), ("-7/4", 0, 0)).nearest == Fraction(8, 7)


@given(grasps(), directions)
def test_margin_ends_on_the_boundary(grasp, wrench):
    found = margin(grasp, wrench)
    assert found.resisted == solve(grasp, wrench).stable
    if found.around is None:
        return
    low, high = found.around
    assert low <= 1
    assert solve(grasp, times(wrench, low)).stable
    if high is not None:
        assert high >= 1
        assert solve(grasp, times(wrench, high)).stable
        assert not solve(grasp, times(wrench, high + TINY)).stable


def test_preloads_of_the_paper():
    """Upward forces up to 2 friction P with three contacts, up to 4 friction P with four."""
    assert sufficient_preloads(read_grasp(THREE), (0, 1, 0)).intervals == ((1, None),)
    assert sufficient_preloads(read_grasp(THREE), (0, -1, 0)).intervals == ((0, None),)
    assert sufficient_preloads(read_grasp(FOUR), (0, 3, 0)).least == Fraction(3, 2)
    assert sufficient_preloads(Grasp(), (0, 3, 0)).least is None


def test_more_preload_is_not_always_enough():
    found = sufficient_preloads(gap_grasp(), (-2, 0, 0))
    assert found.intervals == ((0, 1), (2, None))
    for p, stable in [(0, 1), (1, 1), (Fraction(3, 2), 0), (2, 1)]:
        assert solve(gap_grasp().with_preload(p), (-2, 0, 0)).stable == bool(stable)


@given(grasps(), wrenches, st.fractions(0, 6, max_denominator=4))
def test_preloads_agree_with_the_solver(grasp, wrench, preload):
    found = sufficient_preloads(grasp, wrench)
    inside = any(a <= preload and (b is None or preload <= b) for a, b in found.intervals)
    assert inside == solve(grasp.with_preload(preload), wrench).stable
    for low, high in found.intervals:
        assert solve(grasp.with_preload(low), wrench).stable
        assert high is None or solve(grasp.with_preload(high), wrench).stable


@pytest.mark.parametrize(
    ("name", "wrench", "least"),
    [
        # Upward force 2 friction (three contacts) or 4 friction (four) with preload 1.
        (THREE, (0, 1, 0), Fraction(1, 2)),
        (THREE, (0, "1/2", 0), Fraction(1, 4)),
        (THREE, (0, 5, 0), Fraction(5, 2)),
        (FOUR, (0, 2, 0), Fraction(1, 2)),
        (FOUR, (0, "2/3", 0), Fraction(1, 6)),
        (THREE, (0, -1, 0), Fraction(0)),
    ],
)
def test_least_friction_of_the_paper_grasps(name, wrench, least):
    found = least_friction(read_grasp(name), wrench, "1/1000")
    assert found.low <= least == found.high
    assert found.width <= Fraction(1, 1000)


def test_tolerance_of_friction_has_a_least_value():
    grasp = read_grasp(THREE)
    assert least_friction(grasp, (0, -1, 0), Fraction(1, 2**100)).high == 0
    with pytest.raises(GraspError, match=r"at least 2\^-100"):
        least_friction(grasp, (0, -1, 0), Fraction(1, 2**100 + 1))


def test_least_friction_with_many_open_ranges_is_refused(monkeypatch):
    contacts = [((-1, -1), (12, 5)), ((1, "1/2"), (12, -5)), (("-5/2", 1), (-5, 12))]
    grasp = Grasp(
        Contact(p, [Fraction(x, 13) for x in n], 1, "1/2" if k < 2 else 1, ["1", "1/2", "1"][k])
        for k, (p, n) in enumerate(contacts)
    )
    monkeypatch.setitem(budget.MAX_SIZES, "open ranges of friction coefficients", 1)
    with pytest.raises(OutOfReachError, match="tolerance 1/4: 2 open ranges of friction coeff"):
        least_friction(grasp, (2, -2, 0), "1/4")


def test_wall_that_nothing_presses_on_bears_no_weight():
    wall = Contact([-1, 0], [1, 0], 1)
    hung, leant = ((push, *(-x for x in wall.tangential_wrench[1:])) for push in (0, -1))
    grasp, body = Grasp([wall]), Solver(Assembly.of_grasp(Grasp([wall])))
    assert least_friction(grasp, hung).impossible
    assert least_friction(body, {"object": hung}).impossible
    assert least_friction(grasp, leant).high == least_friction(body, {"object": leant}).high == 1


def test_friction_without_normal_force_is_none():
    # Of x, u, v: the normal force x with friction u, and u, as a normal force, with friction v.
    x, u, v = ([Fraction(int(j == i)) for j in range(4)] for i in range(3))
    forces, rubbing = [(x, u), (u, v)], [0, 0, 1, -1]
    assert any_friction_does(3, [x, u], [rubbing], forces)
    assert any_friction_does(3, [x, u], [x, rubbing], [])
    # Without x there is no u, then without u no v.
    assert not any_friction_does(3, [x, u], [x, rubbing], forces)
    assert any_friction_does(3, [x, u], [x], forces)
    late = Effort(0)
    with pytest.raises(TimeoutError):
        any_friction_does(3, [x, u], [x, rubbing], forces, late)


@given(
    grasps(least=2),
    directions,
    st.sampled_from([Fraction(1, 2), Fraction(999, 1000)]),
    st.booleans(),
)
def test_below_the_bracket_nothing_is_resisted(grasp, wrench, share, name_first):
    found = least_friction(grasp, wrench, "1/64", [1] if name_first else None)
    rough = tuple(i for i, c in enumerate(grasp, 1) if c.friction)
    assert found.contacts == ((1,) if name_first else rough)
    if found.high is not None:
        assert solve(grasp.with_friction(found.high, found.contacts), wrench).stable
    assume(found.impossible or found.low)
    friction = share * (4 if found.impossible else found.low)
    assert not solve(grasp.with_friction(friction, found.contacts), wrench).stable


def ladder():
    """A ladder of weight 1 with its middle above (2, 0): on a floor, at a smooth wall."""
    return Grasp([Contact([0, 0], [0, 1], 1), Contact([4, 3], [-1, 0], 0)]), (0, -1, -2)


@pytest.mark.parametrize("bodies", [False, True])
def test_smooth_contacts_stay_smooth_unless_named(bodies):
    grasp, weight = ladder()
    if bodies:
        grasp, weight = Assembly.of_grasp(grasp), {"object": weight}
    whole = ResistedSet(grasp).margin(weight)
    found = whole.friction("1/1000")
    assert (found.high, found.contacts) == (Fraction(2, 3), (1,))
    assert whole.friction("1/1000", [1, 2]).high == Fraction(1, 2)
    assert whole.friction("1/1000", [2]).high == 0
    smooth = ResistedSet(grasp.with_friction(0)).margin(weight).friction()
    assert (smooth.impossible, smooth.contacts) == (True, ())
    assert smooth.to_dict()["contacts"] == []
    half = grasp.with_friction("1/2", [1])
    assert ResistedSet(half).margin(weight).friction("1/64", [2]).high == Fraction(1, 2)
    with pytest.raises(GraspError, match=r"contacts are \[3\]; expected .* from 1 to 2"):
        whole.friction("1/1000", [3])


@pytest.mark.parametrize(
    ("contacts", "message"),
    [
        ([], "expected at least one"),
        ([0], r"contacts are \[0\]; expected numbers of contacts from 1 to 2"),
        ([1, "a"], r"contacts\[1\] is 'a'; give an integer"),
        ([True], "give an integer"),
        (3, "contacts is 3; give a sequence of numbers of contacts"),
    ],
)
def test_bad_choices_of_contacts_are_refused(contacts, message):
    grasp, weight = ladder()
    for whole, load in [(grasp, weight), (Assembly.of_grasp(grasp), {"object": weight})]:
        with pytest.raises(InputError, match=message):
            ResistedSet(whole).margin(load).friction(contacts=contacts)
        with pytest.raises(InputError, match=message):
            ResistedSet(whole).preloads([load], contacts)


def test_coefficients_far_above_1_are_found():
    steep = [Contact([1, 1], [-1, 0], 1), Contact([-2, 1], ["-4/5", "3/5"], 1, 5)]
    found = least_friction(Grasp(steep), (-3, -20, -1), "1/16")
    assert found.low < found.high == Fraction(517, 4)


def test_preloads_of_chosen_contacts_of_an_assembly_are_those_of_its_grasp():
    grasp, loads = read_grasp(THREE), [[0, 1, 0], [0, 3, 0]]
    body = ResistedSet(Assembly.of_grasp(grasp))
    for contacts in ([1, 3], [2], [1, 2, 3], None):
        found = body.preloads([{"object": load} for load in loads], contacts)
        assert found.intervals == ResistedSet(grasp).preloads(loads, contacts).intervals
    with pytest.raises(GraspError, match=r"contacts are \[4\]"):
        body.preloads([{"object": loads[0]}], [4])


def test_the_search_finds_the_end_of_one_interval():
    for end in (Fraction(0), Fraction(1, 3), Fraction(7), Fraction(99)):
        found = binary_search([(Fraction(0), end)], Fraction(1, 100), Fraction(100))
        assert 0 <= end - found <= Fraction(1, 100)
    assert binary_search([(Fraction(0), None)], Fraction(1, 100), Fraction(100)) is None


def test_the_search_passes_over_a_gap_or_stops_before_it():
    one, two, ten = Fraction(1), Fraction(2), Fraction(10)
    over = compare((one, 0), ((0, one), (two, None)), Fraction(1, 8), ten)
    assert over.found is None
    assert over.wrongly_claimed == ((one, two),)
    before = compare((one, 0), ((0, one), (two, Fraction(9, 4))), Fraction(1, 8), ten)
    assert one - before.found <= Fraction(1, 8)
    assert before.missed == ((two, Fraction(9, 4)),)
    assert not over.agrees
    assert not before.agrees


def test_maps_of_the_paper_agree_with_the_exact_sets():
    """On its two grasps the paper's maps by search are right; where sets have gaps they are not."""
    for name in (THREE, FOUR, "paper-three-contacts", "paper-four-contacts"):
        found = search_map(read_grasp(name), rays=24)
        assert found.disagreements == ()
    wrong = search_map(gap_grasp(), rays=4)
    assert [entry.direction for entry in wrong.disagreements] == [(-1, 0)]


def test_point_just_within_the_tolerance_is_not_missed():
    """From 7 the search ends at 7/2; only above 7/2 + 1 is a resisted magnitude missed."""
    exact = ((Fraction(0), Fraction(18, 5)), (Fraction(89, 20), Fraction(9, 2)))
    found = compare((Fraction(1), Fraction(0)), exact, Fraction(1), Fraction(7))
    assert (found.found, found.missed) == (Fraction(7, 2), ())


@pytest.mark.parametrize("name", ["rays", "tolerance", "max_magnitude"])
def test_search_map_without_size_is_refused(name):
    with pytest.raises(GraspError, match="all must be above 0"):
        search_map(read_grasp(THREE), **{name: 0})


def test_corners_of_a_polygon_end_with_the_lowest():
    """Counter-clockwise; here the lowest corner is not the leftmost one."""
    triangle = from_conditions([(1, 1, 0), (1, -2, 3), (-2, 1, 3)], [], 2)
    assert polygon_cycle(triangle) == ((3, 3), (-1, 1), (1, -1))


def test_what_no_preload_holds_a_small_one_may_lose():
    """Preload p resists a load of 1 as preload 1 resists 1 / p: not between 5/2 and 4."""
    found = sufficient_preloads(read_grasp("interrupted-resistance"), (0, 1, 0))
    assert found.intervals == ((0, Fraction(1, 4)), (Fraction(2, 5), None))
