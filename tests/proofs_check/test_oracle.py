"""The brute force over contact states: known rows, properties, and agreement with the solver."""

from fractions import Fraction

from hypothesis import given, strategies as st

from equilibrium.decide.solver import solve
from proofs_check.instances.domains import contact_numbers
from proofs_check.instances.grasps import grasp_of, paper_question
from proofs_check.instances.printed import FOUR_CONTACT_GRASP, THREE_CONTACT_GRASP
from proofs_check.routes.oracle import (
    Question,
    normal_forces,
    project,
    resisted,
    stable,
    violations,
)
from tests.equilibrium.strategies import grasps, wrenches

questions = st.builds(
    lambda grasp, wrench: Question(
        tuple(map(contact_numbers, grasp)), tuple(map(Fraction, wrench))
    ),
    grasps(),
    wrenches,
)
ZERO, ONE, HALF = Fraction(0), Fraction(1), Fraction(1, 2)


def test_a_boundary_is_decided_exactly():
    tiny = Fraction(1, 10**30)
    assert stable(paper_question(THREE_CONTACT_GRASP, (ZERO, ONE, ZERO), 1))
    assert not stable(paper_question(THREE_CONTACT_GRASP, (ZERO, ONE + tiny, ZERO), 1))


def test_the_resisted_set_is_the_one_of_the_text():
    up = (ZERO, ONE, ZERO)
    assert resisted(paper_question(FOUR_CONTACT_GRASP, up, 1)) == ((Fraction(-2), Fraction(2)),)
    assert resisted(paper_question(FOUR_CONTACT_GRASP, up, 0)) == ((ZERO, ZERO),)


@given(questions)
def test_the_solver_agrees(question):
    verdict = solve(grasp_of(question), question.wrench)
    assert stable(question) == verdict.stable
    for piece in verdict.equilibria:
        assert violations(question, piece.motion, piece.forces) == ()


@given(questions)
def test_normal_forces_exist_exactly_when_stable(question):
    found = normal_forces(question)
    assert all(bool(intervals) == stable(question) for intervals in found)
    assert all(low is not None and low >= 0 for values in found for low, _ in values)


def test_every_condition_is_noticed():
    question = paper_question(THREE_CONTACT_GRASP, (ZERO, ONE, ZERO), 1)
    motion = (ZERO, ONE, ZERO)
    forces = [[ONE, -HALF], [ZERO, ZERO], [ONE, HALF]]
    assert violations(question, motion, forces) == ()
    assert violations(question, motion, [[ONE, -ONE], *forces[1:]]) == (
        "cone of contact 1",
        "dissipation at contact 1",
        "balance",
    )
    assert violations(question, motion, [[ONE, HALF], *forces[1:]]) == (
        "dissipation at contact 1",
        "balance",
    )
    assert "spring of contact 2" in violations(
        question, motion, [forces[0], [ONE, ZERO], forces[2]]
    )


def test_friction_opposes_slip_in_both_directions():
    """Contacts 1 and 3 slip in opposite directions; each may have its friction turned round."""
    question = paper_question(THREE_CONTACT_GRASP, (ZERO, -3 * ONE, ZERO), 1)
    motion = (ZERO, -ONE, ZERO)
    forces = [[ONE, HALF], [2 * ONE, ZERO], [ONE, -HALF]]
    assert violations(question, motion, forces) == ()
    for contact in (0, 2):
        normal, tangential = forces[contact]
        for wrong in (-tangential, ZERO):
            turned = [*forces[:contact], [normal, wrong], *forces[contact + 1 :]]
            found = violations(question, motion, turned)
            assert found == (f"dissipation at contact {contact + 1}", "balance")


def test_elimination_finds_ends_and_contradictions():
    def row(*values):
        return tuple(map(Fraction, values))

    box = [row(1, 0, 0), row(-1, 0, 1), row(0, 1, 0), row(0, -1, 1)]
    assert project([row(1, 1, -3)], box, keep=-1) is None
    assert project([row(1, 1, -2)], box, keep=-1) == []
    ends = project([row(1, 1, -1)], box, keep=0)
    assert ends is not None
    assert sorted(ends) == [(-1, 0, 1), (1, 0, 0)]
