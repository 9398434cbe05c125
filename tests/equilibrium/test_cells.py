"""The contact states that are enough: two routes give the same, and every solution has some."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings

from equilibrium import Grasp, contact_states, read_grasp
from equilibrium.certificate.coverage import due_states, sorted_rows
from equilibrium.inputs.random import random_grasp
from equilibrium.solver.contact_states import states_at
from equilibrium.solver.prepared import PreparedGrasp

from . import oracle
from .awkward import question
from .strategies import grasps, wrenches


def due(grasp: Grasp) -> np.ndarray:
    """Return the states that the checker asks for, from the regions of the general engine."""
    planes = grasp.motion_arrangement()
    signs = [region.signs for region in planes.regions()]
    return due_states(planes, np.array(signs, dtype=np.int8).reshape(len(signs), 2 * len(grasp)))


def assert_same(grasp: Grasp) -> None:
    assert np.array_equal(sorted_rows(PreparedGrasp(grasp).codes), due(grasp))
    assert len(PreparedGrasp(grasp).codes) == len(due(grasp))


@settings(max_examples=60, deadline=None)
@given(grasps(4))
def test_solver_and_checker_ask_for_the_same_states(grasp):
    assert_same(grasp)


@pytest.mark.parametrize("seed", range(60))
def test_solver_and_checker_ask_for_the_same_states_of_awkward_grasps(seed):
    assert_same(question(seed).grasp)


@pytest.mark.parametrize(("contacts", "seed"), [(7, 0), (7, 1), (9, 2)])
def test_solver_and_checker_ask_for_the_same_states_of_larger_grasps(contacts, seed):
    assert_same(random_grasp(contacts, seed))


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


@settings(max_examples=25, deadline=None)
@given(grasps(2), wrenches)
def test_every_solution_has_listed_states(grasp, wrench):
    listed = contact_states(grasp)
    for motion, _ in oracle.solutions(grasp, wrench):
        assert any(fits(states, grasp, motion) for states in listed)
        assert fits(states_at(grasp, motion), grasp, motion)


@settings(max_examples=30, deadline=None)
@given(grasps(3))
def test_every_face_has_listed_states(grasp):
    listed = contact_states(grasp)
    for face in grasp.motion_arrangement().iter_faces():
        assert any(fits(states, grasp, face.witness) for states in listed)


def test_states_are_few_and_distinct():
    grasp = random_grasp(6, seed=1)
    listed = contact_states(grasp)
    assert len(set(listed)) == len(listed) < 4**6 / 8


def test_no_contact_has_the_one_empty_choice():
    assert contact_states(Grasp()) == ((),)
    assert PreparedGrasp(Grasp()).codes.shape == (1, 0)


def test_all_stick_is_among_the_states_of_a_preloaded_grasp():
    assert ("stick",) * 3 in contact_states(read_grasp("paper-three-contacts-preload-1"))
    assert ("stick",) * 3 not in contact_states(read_grasp("paper-three-contacts"))


def test_a_false_match_of_hashes_can_only_ask_for_more(monkeypatch):
    """With equal keys for all planes many rows collide; no state that is due gets lost."""
    grasp = read_grasp("paper-three-contacts-preload-1")
    right = set(map(tuple, due(grasp).tolist()))

    class Constant:
        def integers(self, *_: object, **__: object) -> np.ndarray:
            return np.full(6, 1, dtype=np.uint64)

    monkeypatch.setattr(np.random, "default_rng", lambda *_: Constant())
    found = set(map(tuple, due(grasp).tolist()))
    assert right < found
