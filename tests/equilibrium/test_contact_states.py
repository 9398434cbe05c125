"""The contact states that are enough: every solution and every face has some."""

import pytest
from hypothesis import given

from equilibrium import Grasp, Solver, contact_states, read_grasp
from equilibrium.grasps.inputs.random import random_grasp
from equilibrium.plane.states.contact_states import states_at

from . import oracle
from .awkward import question
from .strategies import grasps, wrenches


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


@given(grasps(2), wrenches)
def test_every_solution_has_listed_states(grasp, wrench):
    listed = contact_states(grasp)
    for found in oracle.solutions(grasp, wrench):
        assert any(fits(states, grasp, found.motion) for states in listed)
        assert fits(states_at(grasp, found.motion), grasp, found.motion)


def assert_every_face_has_states(grasp: Grasp) -> None:
    listed = contact_states(grasp)
    for face in grasp.motion_arrangement().iter_faces():
        assert any(fits(states, grasp, face.witness) for states in listed)


@given(grasps(3))
def test_every_face_has_listed_states(grasp):
    assert_every_face_has_states(grasp)


@pytest.mark.campaign
@pytest.mark.parametrize("seed", range(0, 60, 3))
def test_every_face_of_an_awkward_grasp_has_listed_states(seed):
    assert_every_face_has_states(question(seed).grasp)


def test_states_are_few_and_distinct():
    grasp = random_grasp(6, seed=1)
    listed = contact_states(grasp)
    assert len(set(listed)) == len(listed) < 4**6 / 8


def test_no_contact_has_the_one_empty_choice():
    assert contact_states(Grasp()) == ((),)
    assert Solver(Grasp()).screen.codes.shape == (1, 0)


def test_all_stick_is_among_the_states_of_a_preloaded_grasp():
    assert ("stick",) * 3 in contact_states(read_grasp("paper-three-contacts-preload-1"))
    assert ("stick",) * 3 not in contact_states(read_grasp("paper-three-contacts"))
