"""The complete decision: known cases, laws, and brute force over all 4^m states."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest
from hypothesis import given, settings, strategies as st

from equilibrium import Contact, Grasp, GraspError, read_grasp, solve

from . import oracle
from .strategies import grasps, wrenches

TINY = Fraction(1, 10**30)
THREE = read_grasp("paper-three-contacts-preload-1")
FOUR = read_grasp("paper-four-contacts-preload-1")


@settings(max_examples=40, deadline=None)
@given(grasps(), wrenches)
def test_brute_force_agrees(grasp, wrench):
    verdict = solve(grasp, wrench)
    found = list(oracle.solutions(grasp, wrench))
    assert verdict.stable == bool(found)
    for one in found:
        assert any(piece.contains(one.motion, one.forces) for piece in verdict.equilibria)


@settings(max_examples=60, deadline=None)
@given(grasps(4), wrenches)
def test_every_reported_equilibrium_satisfies_the_definition(grasp, wrench):
    for piece in solve(grasp, wrench).equilibria:
        assert oracle.satisfies(grasp, wrench, piece.motion, piece.forces)
        assert piece.contains(piece.motion, piece.forces)


@settings(max_examples=60, deadline=None)
@given(grasps(4), wrenches)
def test_verdict_agrees_with_its_certificate(grasp, wrench):
    verdict = solve(grasp, wrench)
    assert verdict.verify()
    assert verdict.certificate.kind == ("resisted" if verdict.stable else "not resisted")


@settings(max_examples=40, deadline=None)
@given(grasps(), wrenches)
def test_pieces_are_maximal(grasp, wrench):
    pieces = solve(grasp, wrench).equilibria
    for one in pieces:
        assert not any(one.within(other) for other in pieces if other is not one)


@pytest.mark.parametrize(
    ("name", "wrench", "states"),
    [
        ("paper-three-contacts-preload-1", (0, 1, 0), [("slip+", "detached", "slip-")]),
        ("interrupted-resistance", (0, 0, 1), [("slip+", "slip+", "detached")]),
        (
            "offset-three-contacts",
            (0, 0, 0),
            [("detached", "detached", "detached"), ("slip+", "detached", "slip+")],
        ),
    ],
)
def test_a_larger_piece_is_not_lost_for_a_point_of_it(name, wrench, states):
    """States of a contact on the border of slip and stick hold a part of the solutions only."""
    grasp = read_grasp(name)
    pieces = solve(grasp, wrench).equilibria
    assert [piece.states for piece in pieces] == states
    for found in oracle.solutions(grasp, wrench):
        assert any(piece.contains(found.motion, found.forces) for piece in pieces)


@settings(max_examples=40, deadline=None)
@given(grasps(), wrenches, st.sampled_from([2, Fraction(1, 3), 10**20]))
def test_scaling_wrench_and_preload_scales_motion_and_forces(grasp, wrench, factor):
    scaled = Grasp(replace(c, preload=factor * c.preload) for c in grasp)
    before = solve(grasp, wrench).equilibria
    after = solve(scaled, [factor * w for w in wrench]).equilibria
    assert len(before) == len(after)
    for one, other in zip(before, after, strict=True):
        assert other.motion == tuple(factor * x for x in one.motion)
        assert other.forces == tuple((factor * n, factor * t) for n, t in one.forces)


@settings(max_examples=40, deadline=None)
@given(grasps(), wrenches)
def test_scaling_all_stiffness_scales_motion_only(grasp, wrench):
    stiff = Grasp(replace(c, stiffness=3 * c.stiffness) for c in grasp)
    before, after = solve(grasp, wrench).equilibria, solve(stiff, wrench).equilibria
    assert [p.forces for p in before] == [p.forces for p in after]
    assert [p.motion for p in before] == [tuple(3 * x for x in p.motion) for p in after]


def turned(v, cosine, sine):
    return (cosine * v[0] - sine * v[1], sine * v[0] + cosine * v[1])


@settings(max_examples=40, deadline=None)
@given(
    grasps(),
    wrenches,
    st.sampled_from(
        [(0, 1), (Fraction(3, 5), Fraction(4, 5)), (Fraction(-5, 13), Fraction(12, 13))]
    ),
)
def test_rotating_the_frame_changes_no_force(grasp, wrench, angle):
    rotated = Grasp(
        replace(c, point=turned(c.point, *angle), normal=turned(c.normal, *angle)) for c in grasp
    )
    before = solve(grasp, wrench).equilibria
    after = solve(rotated, (*turned(wrench[:2], *angle), wrench[2])).equilibria
    carried = {((*turned(p.motion[:2], *angle), p.motion[2]), p.forces) for p in before}
    assert carried == {(p.motion, p.forces) for p in after}


@settings(max_examples=40, deadline=None)
@given(grasps(), wrenches, st.tuples(st.integers(-3, 3), st.integers(-3, 3)))
def test_moving_the_origin_keeps_the_solutions(grasp, wrench, shift):
    a, b = shift
    moved = Grasp(replace(c, point=(c.point[0] + a, c.point[1] + b)) for c in grasp)
    torque = wrench[2] + a * wrench[1] - b * wrench[0]
    before, after = solve(grasp, wrench), solve(moved, (*wrench[:2], torque))
    assert before.stable == after.stable
    for p in before.equilibria:
        x, y, r = p.motion
        carried = (x + r * b, y - r * a, r)
        assert any(other.contains(carried, p.forces) for other in after.equilibria)


@settings(max_examples=40, deadline=None)
@given(grasps(), wrenches)
def test_mirror_image_turns_tangential_forces_round(grasp, wrench):
    mirrored = Grasp(
        replace(c, point=(-c.point[0], c.point[1]), normal=(-c.normal[0], c.normal[1]))
        for c in grasp
    )
    before = solve(grasp, wrench).equilibria
    after = solve(mirrored, (-wrench[0], wrench[1], -wrench[2])).equilibria
    carried = {
        ((-p.motion[0], p.motion[1], -p.motion[2]), tuple((n, -t) for n, t in p.forces))
        for p in before
    }
    assert carried == {(p.motion, p.forces) for p in after}


@settings(max_examples=30, deadline=None)
@given(grasps(), wrenches, st.randoms(use_true_random=False))
def test_order_of_contacts_does_not_matter(grasp, wrench, random):
    order = list(range(len(grasp)))
    random.shuffle(order)
    shuffled = solve(Grasp(grasp.contacts[i] for i in order), wrench).equilibria
    before = solve(grasp, wrench).equilibria
    assert {(p.motion, tuple(p.forces[i] for i in order)) for p in before} == {
        (p.motion, p.forces) for p in shuffled
    }


@pytest.mark.parametrize(
    ("grasp", "wrench", "stable"),
    [
        (THREE, (0, 1, 0), True),
        (THREE, (0, 1 + TINY, 0), False),
        (FOUR, (0, 2, 0), True),
        (FOUR, (0, 2 + TINY, 0), False),
        (FOUR, (0, -2 - TINY, 0), False),
        (FOUR.with_preload(0), (0, TINY, 0), False),
    ],
)
def test_boundary_rows_are_exact(grasp, wrench, stable):
    verdict = solve(grasp, wrench)
    assert verdict.stable == stable
    assert verdict.verify()


def test_all_contacts_stick_at_rest():
    (piece,) = solve(THREE, (0, -1, 0)).equilibria
    assert piece.states == ("stick",) * 3
    assert piece.motion == (0, 0, 0)
    assert piece.forces == ((1, 0),) * 3


def test_polytope_of_forces_has_exact_ranges_and_least_forces():
    (piece,) = solve(FOUR, (0, 0, 0)).equilibria
    half = Fraction(1, 2)
    assert piece.forces == ((1, 0),) * 4
    assert piece.force_ranges == (((1, 1), (-half, half)),) * 4
    assert not piece.unique


def test_detached_contacts_leave_the_motion_free():
    pieces = solve(FOUR.with_preload(0), (0, 0, 3)).equilibria
    assert len(pieces) == 1
    assert pieces[0].states == ("slip-", "detached", "slip-", "detached")
    assert pieces[0].forces_determined
    assert pieces[0].motion_ranges == ((0, 0), (-1, 1), (1, 1))


def test_least_motion_is_least():
    (piece,) = solve(FOUR.with_preload(0), (0, 0, 3)).equilibria
    assert piece.contains((0, -1, 1), [(1, "1/2"), (0, 0), (1, "1/2"), (0, 0)])
    assert piece.motion == (0, 0, 1)


def test_two_equilibria_with_different_normal_forces_coexist():
    grasp = Grasp(
        [
            Contact((1, 0), (1, 0), 1),
            Contact((-1, -1), (0, 1), 1, 1, 1),
            Contact((0, -1), (0, -1), 1),
        ]
    )
    pieces = solve(grasp, (-2, 0, 0)).equilibria
    assert len(pieces) == 2
    assert all(piece.unique for piece in pieces)
    assert pieces[0].forces[0][0] != pieces[1].forces[0][0]


def test_object_may_run_away_from_all_contacts():
    grasp = Grasp([Contact((0, 0), (1, 0), 1, 1, 1)])
    (piece,) = solve(grasp, (0, 0, 0)).equilibria
    assert piece.all_detached
    assert piece.motion == (1, 0, 0)
    assert piece.motion_ranges[0] == (1, None)
    assert piece.motion_ranges[2] == (None, None)


def test_no_contacts_hold_nothing_but_the_zero_wrench():
    assert solve(Grasp(), (0, 0, 0)).stable
    for wrench in ((1, 0, 0), (0, 0, -TINY)):
        verdict = solve(Grasp(), wrench)
        assert not verdict.stable
        assert verdict.verify()


def test_without_friction_two_opposite_contacts_hold_a_push_along_their_line_only():
    grasp = read_grasp("frictionless-opposed-contacts")
    assert solve(grasp, (5, 0, 0)).stable
    assert not solve(grasp, (5, TINY, 0)).stable


def test_coincident_contacts_share_the_load():
    one, two = Contact((0, 0), (0, 1), 1), Contact((0, 0), (0, 1), 1, 3)
    (piece,) = solve(Grasp([one, two]), (0, -4, 0)).equilibria
    assert [normal for normal, _ in piece.forces] == [1, 3]


def test_equal_solutions_are_reported_once():
    pieces = solve(THREE.with_preload(0), (0, -1, 0)).equilibria
    assert len({(p.motion, p.forces) for p in pieces}) == len(pieces) == 1


def test_wrong_wrench_is_refused():
    for wrench in ((0, 0), (0, 0, 0.5), "123", (0, 0, True)):
        with pytest.raises(ValueError, match="wrench"):
            solve(THREE, wrench)


def test_wrong_question_to_contains_is_refused():
    (piece,) = solve(THREE, (0, 0, 0)).equilibria
    with pytest.raises(GraspError, match="pairs"):
        piece.contains((0, 0, 0), [(0, 0)])
