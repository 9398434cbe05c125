from fractions import Fraction

import pytest
from hypothesis import given, strategies as st

from arrangement.errors import InputError
from equilibrium.decide.verdict import solve
from equilibrium.grasps.files import read_grasp
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.wrench_sets.line import gaps, resisted_magnitudes

from .oracle import intervals, merged
from .strategies import directions, loads as wrenches, wide_grasps as grasps

TINY = Fraction(1, 10**30)
THREE, FOUR = "paper-three-contacts", "paper-four-contacts"


def scaled(direction, t, base=(0, 0, 0)):
    return [b + t * u for b, u in zip(base, direction, strict=True)]


@pytest.mark.parametrize(
    ("name", "direction", "intervals"),
    [
        # [HaasHeger2018], Table I and Section VI: downward forces without limit; upward none
        # without preload, and up to 1 (= 2 friction) with preload 1.
        (THREE, (0, -1, 0), ((0, None),)),
        (THREE, (0, 1, 0), ((0, 0),)),
        (THREE + "-preload-1", (0, -1, 0), ((0, None),)),
        (THREE + "-preload-1", (0, 1, 0), ((0, 1),)),
        # The same paper, Table III and Section VI: |w_y| <= 4 friction = 2 with preload 1, torques
        # without limit.
        (FOUR, (0, 1, 0), ((0, 0),)),
        (FOUR, (0, -1, 0), ((0, 0),)),
        (FOUR, (0, 0, 1), ((0, None),)),
        (FOUR, (0, 0, -1), ((0, None),)),
        (FOUR + "-preload-1", (0, 1, 0), ((0, 2),)),
        (FOUR + "-preload-1", (0, -1, 0), ((0, 2),)),
    ],
)
def test_values_of_the_paper(name, direction, intervals):
    assert resisted_magnitudes(read_grasp(name), direction).intervals == intervals


def test_a_grasp_whose_magnitudes_have_a_gap():
    grasp, direction = read_grasp("interrupted-push"), (-1, 0, 0)
    found = resisted_magnitudes(grasp, direction)
    assert found.intervals == ((0, 1), (2, None))
    assert found.to_dict() == {"intervals": [["0", "1"], ["2", None]]}
    assert not found.from_zero
    for t, stable in [(0, 1), (1, 1), (1 + TINY, 0), (2 - TINY, 0), (2, 1), (1000, 1)]:
        assert solve(grasp, scaled(direction, t)).stable == bool(stable)


def test_seeded_search_finds_gaps_with_three_contacts_and_not_with_one():
    assert next(gaps(1, seed=0, tries=20), None) is None
    example = next(gaps(3, seed=29, tries=12))
    ends = [end for part in example.intervals for end in part if end is not None]
    middle = (ends[1] + ends[2]) / 2 if len(ends) > 2 else ends[0] / 2
    assert all(c.friction <= 1 and c.preload == 1 for c in example.grasp)
    assert not solve(example.grasp, scaled(example.direction, middle)).stable
    assert solve(example.grasp, scaled(example.direction, ends[-1])).stable


@given(st.one_of(*[grasps(most=2)] * 4, grasps(least=3)), directions, wrenches)
def test_all_states_by_brute_force(grasp, direction, base):
    found = resisted_magnitudes(grasp, direction, base).intervals
    assert found == merged(intervals(grasp, direction, base))


@given(grasps(), directions, wrenches, st.fractions(0, 8, max_denominator=4))
def test_same_answer_as_the_solver(grasp, direction, base, t):
    found = resisted_magnitudes(grasp, direction, base)
    assert found.contains(t) == solve(grasp, scaled(direction, t, base)).stable


def test_no_contact_resists_only_the_zero_wrench():
    assert resisted_magnitudes(Grasp(), (1, 0, 0)).intervals == ((0, 0),)
    assert resisted_magnitudes(Grasp(), (1, 0, 0), (-3, 0, 0)).intervals == ((3, 3),)
    assert resisted_magnitudes(Grasp(), (1, 0, 0), (0, 1, 0)).intervals == ()


@pytest.mark.parametrize("direction", [(0, 0, 0), (1, 0), (1, 0, 0, 0), (0.5, 0, 0), "100"])
def test_bad_directions_are_refused(direction):
    with pytest.raises((GraspError, InputError)):
        resisted_magnitudes(Grasp(), direction)
