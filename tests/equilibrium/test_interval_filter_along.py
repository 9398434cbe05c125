"""What floating point rules out along a line of wrenches is ruled out in rationals too."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from equilibrium import Contact, Grasp, Solver, contact_states
from equilibrium.grasps.inputs.random import random_grasp, random_wrench
from equilibrium.plane.contact_rows import sum_row
from equilibrium.plane.states.contact_states import states_of_code
from equilibrium.plane.states.interval_filter import Screen
from equilibrium.plane.states.state_system import state_system
from equilibrium.wrench_sets.line import interval_between, resisted_magnitudes

from .awkward import question
from .strategies import grasps, wrenches
from .test_interval_filter import beside
from .wrench_sets_strategies import directions

ZERO = (Fraction(0),) * 3
W = (Fraction(1), Fraction(-1, 2), Fraction(1, 3))


def assert_nothing_lost(grasp: Grasp, base: tuple, direction: tuple) -> int:
    """Check each choice ruled out by exact elimination; return how many there are."""
    screen = Solver(grasp).screen
    possible = screen.possible(base, direction)
    for row in screen.codes[~possible].tolist():
        ends = (base, sum_row(base, direction, 1))
        systems = (state_system(grasp, states_of_code(row), wrench) for wrench in ends)
        assert interval_between(*systems) in (None, (0, 0))
    return int((~possible).sum())


@settings(max_examples=60, deadline=None)
@given(grasps(4), wrenches, directions)
def test_no_possible_choice_is_ruled_out(grasp, base, direction):
    assert_nothing_lost(grasp, tuple(map(Fraction, base)), tuple(map(Fraction, direction)))


@pytest.mark.parametrize("seed", range(1, 60, 3))
def test_no_possible_choice_of_an_awkward_question_is_ruled_out(seed):
    asked = question(seed)
    direction = random_wrench(seed)
    assert_nothing_lost(asked.grasp, asked.wrench, direction)
    assert_nothing_lost(asked.grasp, ZERO, asked.wrench if any(asked.wrench) else direction)


@pytest.mark.parametrize("digits", [6, 12, 15, 18])
def test_nearly_coincident_contacts(digits):
    grasp = beside(random_grasp(3, seed=1), Fraction(1, 10**digits))
    assert_nothing_lost(grasp, ZERO, W)


@pytest.mark.parametrize("seed", [1, 3])
def test_a_choice_that_touches_the_line_in_one_point_is_kept(seed):
    """The line is laid through an end of what the grasp resists, along another direction."""
    grasp = random_grasp(4, seed)
    direction = random_wrench(seed)
    low, high = resisted_magnitudes(grasp, direction).intervals[0]
    end = high if high is not None else low
    border = tuple(end * x for x in direction)
    # At t = 1 the new line is exactly at the border.
    base = tuple(b - u for b, u in zip(border, W, strict=True))
    assert_nothing_lost(grasp, base, W)
    assert resisted_magnitudes(grasp, W, base).contains(Fraction(1))


@settings(max_examples=40, deadline=None)
@given(grasps(4), wrenches, directions)
def test_the_intervals_are_the_same_without_the_screen(grasp, base, direction):
    found = resisted_magnitudes(grasp, direction, base).intervals
    with pytest.MonkeyPatch.context() as patch:
        everything = np.ones(len(contact_states(grasp)), dtype=bool)
        patch.setattr(Screen, "possible", lambda *_: everything)
        assert resisted_magnitudes(grasp, direction, base).intervals == found


@pytest.mark.campaign
def test_most_choices_are_ruled_out():
    for seed in (0, 1, 2, 3):
        grasp = random_grasp(7, seed)
        assert assert_nothing_lost(grasp, ZERO, W) > 0.7 * len(contact_states(grasp))


@pytest.mark.parametrize("power", [-40, 40, 400])
def test_numbers_that_floats_should_not_see_rule_nothing_out(power):
    scale = Fraction(10) ** power
    assert Solver(random_grasp(3, seed=1)).screen.possible(ZERO, (scale, *W[1:])).all()
    c = random_grasp(1, seed=1).contacts[0]
    stiff = Grasp([replace(c, stiffness=c.stiffness * scale, preload=0)] * 2)
    assert Solver(stiff).screen.possible(ZERO, W).all()


def test_without_contacts_nothing_is_ruled_out():
    assert Solver(Grasp()).screen.possible(ZERO, W).all()


@settings(max_examples=20, deadline=None)
@given(directions, st.integers(1, 3))
def test_frictionless_contacts_at_one_point_resist_their_normal_only(direction, count):
    """Contacts that only touch from one side leave their own normal direction open."""
    grasp = Grasp([Contact((0, 0), (1, 0), 0, 1, 0)] * count)
    resisted = resisted_magnitudes(grasp, direction).intervals
    pushes = direction[0] < 0 and direction[1:] == (0, 0)
    assert resisted == (((0, None),) if pushes else ((0, 0),))
