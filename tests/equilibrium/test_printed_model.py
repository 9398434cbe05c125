"""The literal readings: each option shows the difference that it is there to show."""

from fractions import Fraction

import pytest
from hypothesis import given, settings

from equilibrium import GraspError, read_grasp, solve, solve_literal
from equilibrium.cli.program import LITERAL
from equilibrium.methods.contact_laws.printed_model import OPTIONS

from .strategies import grasps, wrenches

THREE = read_grasp("paper-three-contacts")
FOUR = read_grasp("paper-four-contacts")


@given(grasps(), wrenches)
def test_no_option_is_the_complete_model(grasp, wrench):
    assert solve_literal(grasp, wrench).equilibria == solve(grasp, wrench).equilibria


def verdicts(grasp, wrench, option):
    return solve(grasp, wrench).stable, solve_literal(grasp, wrench, [option]).stable


LOADED = THREE.with_preload(1)


@pytest.mark.parametrize(
    ("grasp", "wrench", "option"),
    [
        (FOUR, (0, 0, 3), "detachment"),
        (FOUR, (0, 0, -3), "detachment"),
        (LOADED, (0, 1, 0), "preload"),
        (LOADED, (0, 1, 0), "signs"),
        (LOADED, (0, -1, 0), "all-stick"),
    ],
)
def test_a_row_of_the_tables_is_lost(grasp, wrench, option):
    assert verdicts(grasp, wrench, option) == (True, False)


def test_without_the_cell_check_an_unstable_grasp_passes():
    assert verdicts(read_grasp("unchecked-cell"), (2, 0, 2), "cell-check") == (False, True)


def test_without_merging_coincident_planes_a_facet_is_lost():
    # Motion (0, 1/4, 1/4): contacts 0 and 1 stick, 2 and 3 slip; forces chosen inside the cones.
    grasp = FOUR.with_preload(1)
    motion = (Fraction(0), Fraction(1, 4), Fraction(1, 4))
    forces = []
    for contact in grasp:
        gap = sum(a * b for a, b in zip(contact.normal_wrench, motion, strict=True))
        slip = sum(a * b for a, b in zip(contact.tangential_wrench, motion, strict=True))
        normal = contact.preload - gap
        forces.append((normal, Fraction(0) if slip == 0 else -normal / 2 * (1 if slip > 0 else -1)))
    wrench = [
        -sum(
            n * c.normal_wrench[axis] + t * c.tangential_wrench[axis]
            for c, (n, t) in zip(grasp, forces, strict=True)
        )
        for axis in range(3)
    ]
    assert verdicts(grasp, wrench, "coincident-planes") == (True, False)


def test_stopping_at_the_first_solution_misses_the_second():
    question = read_grasp("several-equilibria"), (-1, 0, 0)
    assert len(solve(*question).equilibria) == 2
    assert len(solve_literal(*question, ["single-solution"]).equilibria) == 1


@given(grasps(), wrenches)
def test_options_that_drop_states_accept_no_more_and_conditions_no_less(grasp, wrench):
    stable = solve(grasp, wrench).stable
    for option in ("detachment", "all-stick", "coincident-planes"):
        assert solve_literal(grasp, wrench, [option]).stable <= stable
    assert stable <= solve_literal(grasp, wrench, ["cell-check"]).stable


@settings(max_examples=20)
@given(grasps(), wrenches)
def test_options_combine_in_any_order(grasp, wrench):
    forward = solve_literal(grasp, wrench, list(OPTIONS))
    assert forward == solve_literal(grasp, wrench, list(OPTIONS)[::-1])
    assert forward.options == tuple(OPTIONS)


def test_unknown_option_is_refused():
    with pytest.raises(GraspError, match="cell-check"):
        solve_literal(THREE, (0, 0, 0), ["cellcheck"])


def test_command_line_knows_every_option():
    assert tuple(OPTIONS) == LITERAL
