"""The contact states that are enough: every solution and every face has some."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given, strategies as st

from arrangement.numbers.linear.programs import Infeasible, Optimal, feasible_point, minimize
from equilibrium import Contact, Grasp, read_grasp, solve
from equilibrium.core.contact_law import LinearQuestion
from equilibrium.core.contact_program import ContactProgram
from equilibrium.decide.state_choices import StateChoices
from equilibrium.grasps.inputs.random import random_grasp, random_wrench
from equilibrium.model.rows import ContactRows
from equilibrium.plane.states.contact_states import contact_states, states_at, states_of_code
from equilibrium.plane.states.equilibrium import equilibrium_of
from equilibrium.plane.states.interval_filter import Screen
from equilibrium.plane.states.min_norm_point import least_point
from equilibrium.wrench_sets.line import resisted_magnitudes

from . import oracle
from .degenerate import question
from .strategies import directions, grasps, resisted, wrenches


def fits(states: tuple[str, ...], grasp: Grasp, motion: tuple) -> bool:
    """Return whether a motion satisfies the closed conditions of states on motions."""
    for contact, state in zip(grasp, states, strict=True):
        gap = sum(a * b for a, b in zip(contact.normal_wrench, motion, strict=True))
        slip = sum(a * b for a, b in zip(contact.tangential_wrench, motion, strict=True))
        force = contact.preload - contact.stiffness * gap
        if force and (force < 0) != (state == "detached"):
            return False
        if force > 0 and state != {1: "slip+", 0: "stick", -1: "slip-"}[(slip > 0) - (slip < 0)]:
            return False
    return True


@given(resisted(grasps(2, least=1)))
def test_every_solution_has_listed_states(question):
    grasp, wrench = question
    listed, solutions = contact_states(grasp), list(oracle.solutions(grasp, wrench))
    assert solutions
    for found in solutions:
        assert any(fits(states, grasp, found.motion) for states in listed)
        assert fits(states_at(grasp, found.motion), grasp, found.motion)


def assert_every_face_has_states(grasp: Grasp) -> None:
    listed = contact_states(grasp)
    for face in grasp.motion_arrangement().iter_faces():
        assert any(fits(states, grasp, face.witness) for states in listed)


@given(grasps(3))
def test_every_face_has_listed_states(grasp):
    assert_every_face_has_states(grasp)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(0, 60, 6))
def test_every_face_of_an_awkward_grasp_has_listed_states(seed):
    assert_every_face_has_states(question(seed).grasp)


def test_states_are_few_and_distinct():
    grasp = random_grasp(6, seed=1)
    listed = contact_states(grasp)
    assert len(set(listed)) == len(listed) < 4**6 / 8


def test_no_contact_has_the_one_empty_choice():
    assert contact_states(Grasp()) == ((),)
    assert StateChoices(Grasp()).screen.codes.shape == (1, 0)


def test_all_stick_is_among_the_states_of_a_preloaded_grasp():
    assert ("stick",) * 3 in contact_states(read_grasp("paper-three-contacts-preload-1"))
    assert ("stick",) * 3 not in contact_states(read_grasp("paper-three-contacts"))


ZERO = (Fraction(0),) * 3
W = (Fraction(1), Fraction(-1, 2), Fraction(1, 3))


def assert_true(grasp: Grasp, wrench: tuple, direction: tuple = ()) -> float:
    """Check each choice ruled out by elimination in rationals; return the share of these."""
    screen = StateChoices(grasp).screen
    possible = screen.possible(wrench, *[direction] * bool(direction))
    for row in screen.codes[~possible].tolist():
        states = states_of_code(row)
        if direction:
            question = LinearQuestion(ContactRows.of_grasp(grasp), wrench, direction)
            assert ContactProgram(question, states).magnitudes() in (None, (0, 0))
        else:
            question = LinearQuestion(ContactRows.of_grasp(grasp), wrench)
            assert equilibrium_of(question, states) is None
    return float((~possible).mean())


@given(grasps(4, least=2), wrenches, directions)
def test_a_choice_ruled_out_has_no_equilibrium(grasp, wrench, direction):
    wrench = tuple(map(Fraction, wrench))
    assume(assert_true(grasp, wrench) + assert_true(grasp, wrench, tuple(map(Fraction, direction))))


@pytest.mark.parametrize("seed", [0, *range(6, 60, 12), 24, 36])
def test_ruled_out_choice_has_no_equilibrium(seed):
    asked, direction = question(seed), random_wrench(seed)
    assert assert_true(asked.grasp, asked.wrench)
    assert assert_true(asked.grasp, asked.wrench, direction)
    assert assert_true(asked.grasp, ZERO, asked.wrench if any(asked.wrench) else direction)


@pytest.mark.parametrize(
    ("digits", "line"), [(18, [ZERO, W]), *((digits, [W]) for digits in (3, 9, 12, 18, 30))]
)
def test_nearly_coincident_contacts(digits, line):
    grasp, shift = random_grasp(3, seed=1), Fraction(1, 10**digits)
    moved = (replace(c, point=(c.point[0] + shift, c.point[1])) for c in grasp)
    twice = Grasp([*grasp, *moved])
    assert assert_true(twice, *line)


@pytest.mark.parametrize("power", [-25, -12, 6, 12])
def test_stiffness_and_size_of_very_different_scale(power):
    scale = Fraction(10) ** power
    first, second, *others = random_grasp(4, seed=1)
    far = replace(second, point=[x * scale for x in second.point])
    stiff = replace(first, stiffness=first.stiffness * scale)
    assert assert_true(Grasp([stiff, far, *others]), W)


@pytest.mark.parametrize("power", [-400, -40, 40, 400])
def test_extreme_numbers_left_to_rationals(power):
    (c,) = random_grasp(1, seed=1)
    scale = Fraction(10) ** power
    grasp = Grasp([replace(c, stiffness=c.stiffness * scale, preload=0)] * 2)
    assert StateChoices(grasp).screen.possible(W).all()
    assert StateChoices(grasp).screen.possible(ZERO, W).all()
    for wrench in (W, tuple(-2 * x for x in (*c.normal, c.normal_wrench[2]))):
        assert solve(grasp, wrench).stable == oracle.is_stable(grasp, wrench)
    other = StateChoices(random_grasp(3, seed=1)).screen
    assert other.possible((scale, *W[1:])).all()
    assert other.possible(ZERO, (scale, *W[1:])).all()
    assert StateChoices(Grasp()).screen.possible(ZERO, W).all()


@pytest.mark.parametrize("seed", [1, 3])
def test_a_choice_that_touches_the_line_in_one_point_is_kept(seed):
    """The line is laid through an end of what the grasp resists, along another direction."""
    grasp, direction = random_grasp(4, seed), random_wrench(seed)
    low, high = resisted_magnitudes(grasp, direction).intervals[0]
    end = high if high is not None else low
    # At t = 1 the new line is exactly at the boundary.
    base = tuple(end * b - u for b, u in zip(direction, W, strict=True))
    assert assert_true(grasp, base, W)
    assert resisted_magnitudes(grasp, W, base).contains(Fraction(1))


@pytest.mark.parametrize(
    ("seed", "line", "share"),
    [(1, [W], 0.9), (3, [W], 0.9), pytest.param(0, [ZERO, W], 0.7, marks=pytest.mark.slow)],
)
def test_most_choices_are_decided_in_floating_point(seed, line, share):
    assert assert_true(random_grasp(7, seed), *line) > share


@given(grasps(3), wrenches, directions)
def test_without_floats_the_answers_are_the_same(grasp, wrench, direction):
    pieces = solve(grasp, wrench).equilibria
    found = resisted_magnitudes(grasp, direction, wrench).intervals
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Screen, "possible", lambda self, *_: np.ones(len(self.codes), dtype=bool))
        assert solve(grasp, wrench).equilibria == pieces
        assert resisted_magnitudes(grasp, direction, wrench).intervals == found


@given(directions, st.integers(1, 3))
def test_frictionless_contacts_resist_only_their_normal(direction, count):
    """Contacts that only touch from one side leave their own normal direction open."""
    grasp = Grasp([Contact((0, 0), (1, 0), 0, 1, 0)] * count)
    pushes = direction[0] < 0 and direction[1:] == (0, 0)
    resisted = resisted_magnitudes(grasp, direction).intervals
    assert resisted == (((0, None),) if pushes else ((0, 0),))


def rows(*entries):
    return [tuple(map(Fraction, row)) for row in entries]


row = st.tuples(*[st.integers(-3, 3)] * 3, st.integers(-4, 4))


@given(st.lists(row, max_size=6), st.lists(row, max_size=1))
def test_no_point_lies_beyond_the_supporting_plane(inequalities, equalities):
    least, equal = rows(*inequalities), rows(*equalities)
    assume(not isinstance(feasible_point(3, least, equal), Infeasible))
    image = rows((1, 0, 0, 0), (0, 1, 0, 0))
    x, y = least_point(3, least, equal, image)
    # x is least exactly when it is attained and <x, v> >= <x, x> for every v.
    reached = [*equal, *rows((1, 0, 0, -x), (0, 1, 0, -y))]
    assert not isinstance(feasible_point(3, least, reached), Infeasible)
    answer = minimize((x, y, 0), least, equal)
    assert isinstance(answer, Optimal)
    assert answer.value == x * x + y * y


@pytest.mark.parametrize(("weight", "intervals"), [(-2, ((0, 0),)), (2, ())])
def test_load_along_which_nothing_holds_leaves_its_base(weight, intervals):
    """Two frictionless legs on a table hold a weight, no lift, and nothing along the table."""
    legs = Grasp(Contact((x, 0), (0, 1), 0) for x in (-1, 1))
    assert resisted_magnitudes(legs, (1, 0, 0), (0, weight, 0)).intervals == intervals
