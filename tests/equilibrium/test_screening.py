"""What floating point decides about contact states is true, and it decides most of them."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from equilibrium import Contact, Grasp, Solver, read_grasp, solve
from equilibrium.certificate.conditions import conditions_of, violation_problem
from equilibrium.certificate.determinants import KINDS, proven_violations
from equilibrium.inputs.random import random_grasp, random_wrench
from equilibrium.solver.all_stick import rest_refutation
from equilibrium.solver.contact_states import states_of_code
from equilibrium.solver.elimination import Refutation, decide, point_with_idle
from equilibrium.solver.interval_filter import CONDITIONS, UNDECIDED, Screen
from equilibrium.solver.lemke import likely_states
from equilibrium.solver.prepared import PreparedGrasp
from equilibrium.solver.refutations import Balances
from equilibrium.solver.state_system import state_system, value

from . import oracle
from .awkward import question
from .strategies import grasps, wrenches

TINY = Fraction(1, 10**9)
W = (Fraction(1), Fraction(-1, 2), Fraction(1, 3))


def assert_true(grasp: Grasp, wrench: tuple) -> int:
    """Check every answer of the screen by determinants in rationals; return how many there are."""
    screen = PreparedGrasp(grasp).screen
    found = screen.violations(wrench)
    decided = 0
    for row, index in zip(screen.codes.tolist(), found.tolist(), strict=True):
        if index != UNDECIDED:
            kind, contact = divmod(index, len(grasp))
            states = states_of_code(row)
            assert violation_problem(grasp, wrench, states, CONDITIONS[kind], contact) == ""
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
    moved = (
        Contact((c.point[0] + shift, c.point[1]), c.normal, c.friction, c.stiffness, c.preload)
        for c in grasp
    )
    return Grasp([*grasp, *moved])


@pytest.mark.parametrize("digits", [3, 6, 9, 12, 15, 18, 30])
def test_nearly_coincident_contacts(digits):
    grasp = beside(random_grasp(3, seed=1), Fraction(1, 10**digits))
    assert_true(grasp, W)


@pytest.mark.parametrize("power", [-25, -12, 12, 25])
def test_stiffness_and_size_of_very_different_scale(power):
    scale = Fraction(10) ** power
    contacts = [
        Contact(
            [x * (scale if i == 1 else 1) for x in c.point],
            c.normal,
            c.friction,
            c.stiffness * (scale if i == 0 else 1),
            c.preload,
        )
        for i, c in enumerate(random_grasp(4, seed=1))
    ]
    assert_true(Grasp(contacts), W)


@pytest.mark.parametrize("power", [-400, -40, 40, 400])
def test_numbers_that_floats_should_not_see_are_left_to_rationals(power):
    c = random_grasp(1, seed=1).contacts[0]
    scale = Fraction(10) ** power
    grasp = Grasp([Contact(c.point, c.normal, c.friction, c.stiffness * scale, 0)] * 2)
    assert set(PreparedGrasp(grasp).screen.violations(W).tolist()) == {UNDECIDED}
    states = PreparedGrasp(grasp).codes
    assert not proven_violations(
        grasp, W, states, np.zeros(len(states), dtype=int), np.zeros(len(states), dtype=int)
    ).any()
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
@given(grasps(3), wrenches, st.sampled_from(KINDS), st.integers(0, 2))
def test_opposite_determinants_are_only_proven_where_rationals_agree(grasp, wrench, kind, contact):
    states = PreparedGrasp(grasp).codes
    fitting = {"normal": (1, 0, -1, 2), "slip": (1, -1)}.get(kind, (0,))
    if contact < len(grasp):
        states = states[np.isin(states[:, contact], fitting)]
        kinds = np.full(len(states), KINDS.index(kind))
        proven = proven_violations(grasp, wrench, states, kinds, np.full(len(states), contact))
        for row, sure in zip(states.tolist(), proven.tolist(), strict=True):
            if sure:
                assert not violation_problem(grasp, wrench, states_of_code(row), kind, contact)


def test_determinants_prove_what_the_screen_found():
    for seed in (0, 1, 2, 3):
        grasp, wrench = random_grasp(6, seed), random_wrench(seed)
        found = PreparedGrasp(grasp).screen.violations(wrench)
        decided = found != UNDECIDED
        kinds, contacts = np.divmod(found[decided], 6)
        proven = proven_violations(
            grasp, wrench, PreparedGrasp(grasp).codes[decided], kinds, contacts
        )
        assert proven.mean() > 0.9


@settings(max_examples=40, deadline=None)
@given(grasps(3), wrenches)
def test_without_search_and_without_floats_the_answer_is_the_same(grasp, wrench):
    fast = solve(grasp, wrench)
    pieces = fast.equilibria
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Solver, "_quick_solution", lambda *_: None)
        patch.setattr(Screen, "violations", lambda self, _: np.full(len(self.codes), UNDECIDED))
        slow = solve(grasp, wrench)
        assert slow.stable == fast.stable
        assert slow.equilibria == pieces


def test_the_search_finds_most_stable_grasps_and_what_it_finds_is_exact():
    found = 0
    for seed in range(40):
        grasp, wrench = random_grasp(10, seed), random_wrench(seed)
        guess = likely_states(grasp, wrench)
        if guess is None:
            continue
        system = state_system(grasp, guess.states, wrench)
        z = point_with_idle(system, guess.idle)
        if z is not None:
            found += 1
            assert all(value(row, z) == 0 for row in system.equalities)
            assert all(value(row, z) >= 0 for row in system.inequalities)
    assert found > 30


def test_several_contacts_stick_at_rest_and_some_are_idle():
    grasp = read_grasp("paper-four-contacts").with_preload(1)
    guess = likely_states(grasp, (Fraction(0), Fraction(1), Fraction(0)))
    assert guess is not None
    assert guess.states.count("stick") == 4
    assert guess.idle
    assert solve(grasp, (0, 1, 0)).solution is not None


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
                conditions = conditions_of(grasp, wrench, states)
                assert not conditions.refutation_problem(
                    refutation.inequalities, refutation.equalities
                )
                assert isinstance(decide(state_system(grasp, states, wrench)), Refutation)


def test_rest_is_refuted_without_a_program():
    grasp = random_grasp(8, seed=1)
    states = ("stick",) * 8
    strong = tuple(Fraction(100) * x for x in W)
    assert rest_refutation(grasp, strong, states) is not None
    assert rest_refutation(grasp, W, ("slip+",) * 8) is None
