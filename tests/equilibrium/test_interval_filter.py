"""What floating point decides about contact states is true, and it decides most of them."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings

from equilibrium import Grasp, solve
from equilibrium.inputs.random import random_grasp
from equilibrium.solver.all_stick import rest_refutation
from equilibrium.solver.contact_states import states_of_code
from equilibrium.solver.elimination import Refutation, decide
from equilibrium.solver.interval_filter import UNDECIDED, Screen
from equilibrium.solver.prepared import PreparedGrasp
from equilibrium.solver.refutations import Balances
from equilibrium.solver.state_system import state_system

from . import oracle
from .awkward import question
from .strategies import grasps, wrenches

TINY = Fraction(1, 10**9)
W = (Fraction(1), Fraction(-1, 2), Fraction(1, 3))


def assert_true(grasp: Grasp, wrench: tuple) -> int:
    """Check every answer of the screen by elimination in rationals; return how many there are."""
    screen = PreparedGrasp(grasp).screen
    found = screen.violations(wrench)
    decided = 0
    for row, index in zip(screen.codes.tolist(), found.tolist(), strict=True):
        if index != UNDECIDED:
            system = state_system(grasp, states_of_code(row), wrench)
            assert isinstance(decide(system), Refutation)
            decided += 1
    return decided


@settings(max_examples=60, deadline=None)
@given(grasps(4), wrenches)
def test_a_decided_choice_violates_the_named_condition(grasp, wrench):
    assert_true(grasp, tuple(map(Fraction, wrench)))


@pytest.mark.parametrize("seed", range(0, 60, 2))
def test_a_decided_choice_of_an_awkward_question_violates_the_named_condition(seed):
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
    assert set(PreparedGrasp(grasp).screen.violations(W).tolist()) == {UNDECIDED}
    for wrench in (W, tuple(-2 * x for x in (*c.normal, c.normal_wrench[2]))):
        assert solve(grasp, wrench).stable == oracle.is_stable(grasp, wrench)
    assert set(PreparedGrasp(random_grasp(2)).screen.violations((scale, *W[1:])).tolist()) == {
        UNDECIDED
    }


def test_most_choices_are_decided_in_floating_point():
    for seed in (1, 3, 5):
        grasp = random_grasp(7, seed)
        assert assert_true(grasp, W) > 0.9 * len(PreparedGrasp(grasp).codes)


@settings(max_examples=40, deadline=None)
@given(grasps(3), wrenches)
def test_without_floats_the_equilibria_are_the_same(grasp, wrench):
    pieces = solve(grasp, wrench).equilibria
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Screen, "violations", lambda self, _: np.full(len(self.codes), UNDECIDED))
        assert solve(grasp, wrench).equilibria == pieces


@settings(max_examples=60, deadline=None)
@given(grasps(3), wrenches)
def test_quick_refutations_are_farkas_vectors(grasp, wrench):
    applied, balances = tuple(map(Fraction, wrench)), Balances(grasp)
    for row in PreparedGrasp(grasp).codes.tolist():
        states = states_of_code(row)
        for refutation in (
            balances.refutation(applied, states),
            rest_refutation(grasp, applied, states),
        ):
            if refutation is not None:
                system = state_system(grasp, states, applied)
                assert all(y >= 0 for y in refutation.inequalities)
                rows = [*system.inequalities, *system.equalities]
                factors = [*refutation.inequalities, *refutation.equalities]
                combined = [
                    sum(y * row[j] for y, row in zip(factors, rows, strict=True))
                    for j in range(system.size + 1)
                ]
                assert combined == [0] * system.size + [-1]


def test_rest_is_refuted_without_a_program():
    grasp = random_grasp(8, seed=1)
    states = ("stick",) * 8
    strong = tuple(Fraction(100) * x for x in W)
    assert rest_refutation(grasp, strong, states) is not None
    assert rest_refutation(grasp, W, ("slip+",) * 8) is None
