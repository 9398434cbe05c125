"""The solver against brute force over all 4^m contact states, on seeded awkward questions.

The first of the questions; ``python tests/benchmarks/agreement.py`` asks 2,000 of them, and the
mixed-integer program too.
"""

from collections import Counter
from fractions import Fraction

import pytest
from hypothesis import given

from equilibrium import Contact, Grasp, solve

from . import oracle
from .agreement import disagreements
from .awkward import BORDERS, GRASPS, Question, question
from .strategies import grasps, wrenches

CHUNK = 15


@pytest.mark.slow
@pytest.mark.parametrize(
    "chunk", [*range(2), *(pytest.param(k, marks=pytest.mark.campaign) for k in range(2, 40))]
)
def test_solver_agrees_with_brute_force(chunk):
    for seed in range(CHUNK * chunk, CHUNK * (chunk + 1)):
        assert disagreements(question(seed)) == [], seed


@given(grasps(), wrenches)
def test_solver_agrees_on_a_coarse_grid(grasp, wrench):
    assert disagreements(Question(0, grasp, wrench, "grid", "free")) == []


def test_bound_on_the_motion_is_the_largest_component_of_the_motion():
    """One spring of stiffness 1 without friction under the load 12 gives way by 12."""
    grasp, wrench = Grasp([Contact((0, 0), (0, 1), 0)]), (Fraction(0), Fraction(-12), Fraction(0))
    assert oracle.is_stable(grasp, wrench)
    assert oracle.is_stable(grasp, wrench, bound=12)
    assert not oracle.is_stable(grasp, wrench, bound=Fraction(119, 10))


def test_forces_that_cancel_in_one_balance_are_refuted_by_the_others():
    """With slip- the friction torques of the two contacts cancel, whatever the motion."""
    normal, half = (Fraction(1), Fraction(0)), Fraction(1, 2)
    grasp = Grasp([Contact((-1, 0), normal, 1), Contact((1, 0), normal, half, 2)])
    verdict = solve(grasp, (2, Fraction(3, 2), 0))
    assert not verdict.stable
    assert verdict.verify()


def test_questions_are_of_all_kinds():
    asked = [question(seed) for seed in range(80)]
    assert Counter(len(q.grasp) for q in asked) == {2: 20, 3: 20, 4: 20, 5: 20}
    assert {q.kind for q in asked} == set(GRASPS)
    assert {q.load for q in asked} == {"free", "zero", *BORDERS}
