"""What floating point decides about contact states is true, and it decides most of them."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings

from equilibrium import Grasp, Solver, solve
from equilibrium.grasps.inputs.random import random_grasp
from equilibrium.plane.states.contact_states import states_of_code
from equilibrium.plane.states.equilibrium import equilibrium_of
from equilibrium.plane.states.interval_filter import Screen
from equilibrium.plane.states.state_system import state_system

from . import oracle
from .awkward import question
from .strategies import grasps, wrenches

TINY = Fraction(1, 10**9)
W = (Fraction(1), Fraction(-1, 2), Fraction(1, 3))


def assert_true(grasp: Grasp, wrench: tuple) -> int:
    """Check every answer of the screen by elimination in rationals; return how many there are."""
    screen = Solver(grasp).screen
    possible = screen.possible(wrench)
    for row in screen.codes[~possible].tolist():
        assert equilibrium_of(state_system(grasp, states_of_code(row), wrench)) is None
    return int((~possible).sum())


@settings(max_examples=60, deadline=None)
@given(grasps(4), wrenches)
def test_a_choice_ruled_out_has_no_equilibrium(grasp, wrench):
    assert_true(grasp, tuple(map(Fraction, wrench)))


@pytest.mark.parametrize("seed", range(0, 60, 2))
def test_a_choice_ruled_out_of_an_awkward_question_has_no_equilibrium(seed):
    asked = question(seed)
    assert_true(asked.grasp, asked.wrench)


def beside(grasp: Grasp, shift: Fraction) -> Grasp:
    """Return the contacts, each twice, the second time moved a little."""
    moved = (replace(c, point=(c.point[0] + shift, c.point[1])) for c in grasp)
    return Grasp([*grasp, *moved])


@pytest.mark.parametrize("digits", [3, 6, 9, 12, 15, 18, 30])
def test_nearly_coincident_contacts(digits):
    grasp = beside(random_grasp(3, seed=1), Fraction(1, 10**digits))
    assert_true(grasp, W)


@pytest.mark.parametrize("power", [-25, -12, 12, 25])
def test_stiffness_and_size_of_very_different_scale(power):
    scale = Fraction(10) ** power
    contacts = [
        replace(
            c,
            point=[x * (scale if i == 1 else 1) for x in c.point],
            stiffness=c.stiffness * (scale if i == 0 else 1),
        )
        for i, c in enumerate(random_grasp(4, seed=1))
    ]
    assert_true(Grasp(contacts), W)


@pytest.mark.parametrize("power", [-400, -40, 40, 400])
def test_numbers_that_floats_should_not_see_are_left_to_rationals(power):
    c = random_grasp(1, seed=1).contacts[0]
    scale = Fraction(10) ** power
    grasp = Grasp([replace(c, stiffness=c.stiffness * scale, preload=0)] * 2)
    assert Solver(grasp).screen.possible(W).all()
    for wrench in (W, tuple(-2 * x for x in (*c.normal, c.normal_wrench[2]))):
        assert solve(grasp, wrench).stable == oracle.is_stable(grasp, wrench)
    assert Solver(random_grasp(2)).screen.possible((scale, *W[1:])).all()


def test_most_choices_are_decided_in_floating_point():
    for seed in (1, 3, 5):
        grasp = random_grasp(7, seed)
        assert assert_true(grasp, W) > 0.9 * len(Solver(grasp).screen.codes)


@settings(max_examples=40, deadline=None)
@given(grasps(3), wrenches)
def test_without_floats_the_equilibria_are_the_same(grasp, wrench):
    pieces = solve(grasp, wrench).equilibria
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Screen, "possible", lambda self, _: np.ones(len(self.codes), dtype=bool))
        assert solve(grasp, wrench).equilibria == pieces
