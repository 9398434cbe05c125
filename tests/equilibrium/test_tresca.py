"""Equilibria of several bodies from fixed points of Tresca friction."""

import numpy as np
import pytest

from equilibrium import Assembly, BodyContact, Contact, solve
from equilibrium.core import continuation
from equilibrium.core.cones import LineCones
from equilibrium.core.contacts import FloatContacts
from equilibrium.core.relaxation import Relaxation
from equilibrium.grasps.textbook import arch, stack, wall
from equilibrium.model.errors import GraspError


def relaxation(assembly, wrenches):
    load = tuple(x for name in assembly.names for x in wrenches[name])
    return Relaxation(FloatContacts(assembly.rows), load, LineCones())


@pytest.mark.parametrize(
    "made",
    [arch(), stack(blocks=4), wall(courses=3, bricks=2, friction="1/10", overhang=True)],
    ids=["arch", "stack", "wall"],
)
def test_fixed_point_obeys_the_law(made):
    question = relaxation(*made)
    motion, forces = question.at_fixed_limits()
    spring = question.preload - question.stiffness * (question.normal @ motion)
    assert forces[:, 0] == pytest.approx(np.maximum(0, spring), abs=1e-5)
    wrench = forces[:, 0] @ question.normal + forces[:, 1] @ question.tangents[:, 0]
    assert wrench == pytest.approx(-question.load, abs=1e-5)
    limit, slip = question.friction * forces[:, 0], question.tangents[:, 0] @ motion
    assert (np.abs(forces[:, 1]) <= limit + 1e-5).all()
    slips = np.abs(slip * question.stiffness) > 1e-4
    opposed = -np.sign(slip) * limit
    assert forces[slips, 1] == pytest.approx(opposed[slips], abs=1e-5)
    assert slips.any() == (made[0].names[0] == "brick 1.1")


def test_no_fixed_point_where_no_force_balances():
    assembly, wrenches = stack(blocks=3, push=2)
    assert relaxation(assembly, wrenches).at_fixed_limits() is None
    assert solve(assembly, wrenches).verdict == "not resisted"


def test_constant_forces_have_no_energy_of_springs():
    foot = Contact([0, 0], [0, 1], "1/2", stiffness=0, preload=1)
    assembly = Assembly(["block"], [BodyContact("block", None, foot)])
    assert relaxation(assembly, {"block": (0, -1, 0)}).at_fixed_limits() is None


@pytest.mark.parametrize("size", [3, 4])
def test_wall_with_bricks_that_just_touch_is_decided(size):
    """Some bricks touch without force: their contacts are open, and a small tree splits them."""
    made, wrenches = wall(courses=size, bricks=size, friction="1/10", overhang=True)
    verdict = solve(made, wrenches, nodes=1)
    assert verdict.verdict == "resisted"
    assert verdict.verify()


@pytest.mark.parametrize("courses", [6, 10])
def test_wall_needs_no_tree_of_all_states(courses, monkeypatch):
    """Of 33 and of 85 bricks: the higher a wall, the larger its motions beside those of a brick."""
    monkeypatch.setattr(continuation.Continuation, "starts", None)
    bricks = 5 if courses == 6 else 8
    assert solve(*wall(courses=courses, bricks=bricks, friction="1/10")).verdict == "resisted"


def test_wall_is_closed_by_half_bricks():
    made, wrenches = wall(courses=2, bricks=3)
    assert len(made.names) == 7
    assert [str(wrenches[f"brick 2.{k}"][1]) for k in (1, 2, 4)] == ["-1/2", "-1", "-1/2"]
    with pytest.raises(GraspError, match="courses is 0"):
        wall(courses=0)


@pytest.mark.parametrize("damping", [0.0, 1e-8, 0.5])
def test_normal_equations_make_the_same_step(damping):
    source = np.random.default_rng(7)
    for size in (2, 7, 12):
        jacobian, value = source.normal(size=(size, size)), source.normal(size=size)
        step = continuation._step(*np.linalg.svd(jacobian), value, damping)
        assert continuation._normal_step(jacobian, value, damping) == pytest.approx(step)


def test_singular_balance_makes_no_step_without_damping():
    step = continuation._normal_step(np.zeros((7, 7)), np.ones(7), 0.0)
    assert not step.any()
