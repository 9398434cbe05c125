from fractions import Fraction

import pytest
from hypothesis import given, settings, strategies as st

from equilibrium.decide.verdict import solve
from equilibrium.grasps.files import read_grasp
from equilibrium.model.contact import Contact
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.wrench_sets.friction import least_friction
from equilibrium.wrench_sets.margin import margin, sufficient_preloads
from equilibrium.wrench_sets.search_map import binary_search, compare, search_map

from .strategies import directions, loads as wrenches, wide_grasps as grasps

TINY = Fraction(1, 10**30)
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


def test_the_zero_wrench_has_every_factor_or_none():
    assert margin(Grasp(), (0, 0, 0)).around == (0, None)
    pushed = Grasp([Contact((0, 0), (1, 0), 0, 1, 1), Contact((0, 0), (0, 1), 0, 1, 1)])
    assert margin(pushed, (0, 0, 0)).resisted == solve(pushed, (0, 0, 0)).stable


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


def test_no_friction_is_enough_without_preload():
    """[HaasHeger2018], Section VI: for w_y > 0 there is no solution without preload."""
    assert least_friction(read_grasp("paper-three-contacts"), (0, 1, 0)).impossible
    assert not least_friction(read_grasp(THREE), (0, 1, 0), "1/10").impossible


@settings(max_examples=12)
@given(grasps(least=2), directions, st.fractions(0, 4, max_denominator=12))
def test_below_the_bracket_nothing_is_resisted(grasp, wrench, friction):
    found = least_friction(grasp, wrench, "1/64")
    if found.high is not None:
        assert solve(grasp.with_friction(found.high), wrench).stable
    if found.impossible or friction < found.low:
        assert not solve(grasp.with_friction(friction), wrench).stable


def test_a_width_must_be_positive():
    with pytest.raises(GraspError):
        least_friction(Grasp(), (1, 0, 0), 0)


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
        found = search_map(read_grasp(name), directions=24)
        assert found.disagreements == ()
    wrong = search_map(gap_grasp(), directions=4)
    assert [entry.direction for entry in wrong.disagreements] == [(-1, 0)]


def test_maps_refuse_senseless_settings():
    for options in ({"directions": 0}, {"tolerance": 0}, {"limit": -1}):
        with pytest.raises(GraspError):
            search_map(Grasp(), **options)
