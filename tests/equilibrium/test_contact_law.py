"""The law of a contact in a state: by name and in conditions, with one tangent and with two."""

from fractions import Fraction
from itertools import product

import numpy as np
import pytest

from arrangement.numbers.exact import dot
from equilibrium import Contact, Grasp
from equilibrium.core.cones import LineCones, Pyramids, RoundCones
from equilibrium.core.contact_law import ContactState, LinearQuestion, fraction
from equilibrium.core.contact_program import ContactProgram
from equilibrium.core.contacts import FloatContacts
from equilibrium.core.relaxation import Relaxation
from equilibrium.grasps.inputs.random import random_grasp, random_wrench
from equilibrium.model.contact import pyramid_edges
from equilibrium.model.rows import ContactRows
from equilibrium.model.solution import Solution

F = Fraction
NAMES = ("detached", "slip+", "slip-", "stick")
MU = F(1, 2)
#: What these names stand for at a contact with friction, along one tangent.
CONDITIONS = {
    "detached": ContactState("detached"),
    "slip+": ContactState("attached", ((False, (1,)),), share=(-1,)),
    "slip-": ContactState("attached", ((False, (-1,)),), share=(1,)),
    "stick": ContactState("attached", ((True, (1,)),), ((False, (MU, 1)), (False, (MU, -1)))),
}


def posed(contacts, load, **options):
    return LinearQuestion(ContactRows.of_grasp(Grasp(contacts)), tuple(map(F, load)), **options)


def rough(grasp):
    return [Contact(c.point, c.normal, MU, c.stiffness, c.preload) for c in grasp]


@pytest.mark.parametrize("seed", range(6))
def test_names_stand_for_their_conditions(seed):
    question = posed(rough(random_grasp(3, seed)), random_wrench(seed))
    for names in product(NAMES, repeat=3):
        by_name, in_conditions = (
            ContactProgram(question, states)
            for states in (names, tuple(map(CONDITIONS.get, names)))
        )
        assert by_name.inequalities == in_conditions.inequalities
        assert by_name.equalities == in_conditions.equalities


@pytest.mark.parametrize("seed", range(1, 9, 2))
def test_question_at_rest_has_the_solutions_without_motion(seed):
    grasp = rough(random_grasp(4, seed))
    pulls = [[c.preload * x for x in c.normal_wrench] for c in grasp]
    load, feasible = [-sum(column) for column in zip(*pulls, strict=True)], 0
    for question in (posed(grasp, load), posed(grasp, load, max_displacement=F(1))):
        for names in product(("detached", "stick"), repeat=4):
            if names.count("stick") < 3:
                continue
            program, resting = (ContactProgram(x, names) for x in (question, question.at_rest))
            assert program.feasible == resting.feasible
            if program.feasible:
                feasible += 1
                assert program.within(resting)
                assert resting.within(program)
    assert feasible


def test_slip_along_a_known_direction_in_space():
    """A point on a floor with friction 1/2, pushed with twice its limit, and held by a wall."""
    floor = Contact([0, 0, 0], [0, 0, 1], MU, preload=1)
    wall = Contact([0, 0, 0], [-F(3, 5), -F(4, 5), 0], 0)
    (first, second), along = floor.tangential_wrenches, (F(3, 5), F(4, 5), 0, 0, 0, 0)
    share = tuple(-dot(x, along) for x in (first, second))
    sides = (
        (False, tuple(-x for x in share)),
        (True, (share[1], -share[0])),
    )
    load = tuple(x - y for x, y in zip(along, (0, 0, 1, 0, 0, 0), strict=True))
    slips = ContactState("attached", sides, share=share)
    program = ContactProgram(posed([floor, wall], load), (slips, "attached"))
    solution = program.solution()
    assert isinstance(solution, Solution)
    assert solution.forces == ((1, MU * share[0], MU * share[1]), (MU, 0, 0))
    assert dot(along, solution.motion) == MU
    assert program.holds(solution)
    assert not program.holds(Solution(solution.motion, ((1, 0, 0), (MU, 0, 0))))
    # Pulled the other way it would slip against this state.
    back = tuple(-x for x in along[:2]) + load[2:]
    leaf = ContactProgram(posed([floor, wall], back), (slips, "attached")).leaf()
    assert leaf is not None
    assert len(leaf.multipliers[0]) == 3


def test_conditions_do_not_depend_on_the_load():
    question = posed(rough(random_grasp(3, 1)), (0, 0, 0))
    loaded = question.with_load((F(1), F(2), F(3)))
    assert loaded.load == (1, 2, 3)
    assert loaded.conditions(0, "slip+") is question.conditions(0, "slip+")
    (one, other) = (ContactProgram(x, ("slip+",) * 3).equalities for x in (question, loaded))
    assert one != other


@pytest.mark.parametrize(("needed", "feasible"), [(1, False), (F(3, 2), True), (3, True)])
def test_undecided_contact_has_the_force_of_its_spring_at_least(needed, feasible):
    """The spring of preload 2 is let go by 1/2 at most."""
    question = posed(
        [Contact([0, 0], [0, 1], 0, preload=2)], (0, -needed, 0), max_displacement=F(1, 2)
    )
    assert ContactProgram(question, ("undecided",)).feasible == feasible


@pytest.mark.parametrize(("shares", "chosen"), [((), None), ((F(1, 3), 2), None), ((), {1})])
def test_preloads_grow_by_their_shares(shares, chosen):
    contacts = [Contact([k, 0], [0, 1], MU, preload=k) for k in (1, 2)]
    question = posed(
        contacts,
        (0, -5, 0),
        load_slope=(F(0), F(-1), F(0)),
        preload_slope=F(3),
        shares=shares,
        chosen=chosen and frozenset(chosen),
    )
    added = [6 * x for x in shares] or [0 if chosen else 6, 6]
    preloads = [c.preload + x for c, x in zip(contacts, added, strict=True)]
    assert [c.preload for c in question.at(F(2)).rows] == preloads
    (spring,) = question.conditions(1, "detached").least
    assert spring.row == {-1: -2, 1: 1, 2: 2, 3: -3 * (shares[1] if shares else 1)}


def obeys(question, state, motion, forces):
    """Whether the first contact obeys the exact law of a state."""
    law = question.conditions(0, state)
    known = {key: forces[0 if key[0] == "normal" else 1 + key[2]] for key in law.unknowns}

    def value(terms):
        at = {-1: 1, **dict(enumerate(motion)), **known}
        return sum(fraction(x) * at[j] for j, x in question.expanded(terms).items())

    return (
        all(value(terms) == x for terms, x in zip(law.forces, forces, strict=True))
        and all(value(x.terms) >= 0 for x in law.least)
        and all(value(x.terms) == 0 for x in law.equal)
    )


def obeys_in_floats(relaxation, state, motion, forces):
    """The same by the rows of its cone program, whose unknown forces are the first ones."""
    program = relaxation._program([state])
    scaled, shares = np.array(forces, dtype=float) / relaxation.force, program.blocks[0].forces
    unknown = scaled[: shares.shape[1]]
    rows = program.right - program.matrix.table() @ [*motion / relaxation.scale, *unknown]
    ok, start = np.allclose(shares @ unknown, scaled, rtol=0, atol=1e-9), len(motion)
    for kind in program.layout.kinds[1:]:
        part, start = rows[start : start + kind.dim], start + kind.dim
        if "SecondOrder" in str(kind):
            part = part[:1] - np.linalg.norm(part[1:])
        ok &= bool((np.abs(part) < 1e-9 if "Zero" in str(kind) else part > -1e-9).all())
    return ok


@pytest.mark.parametrize("friction", [F(0), MU])
@pytest.mark.parametrize("most", [None, F(1)])
def test_cone_programs_of_floats_have_the_exact_law(friction, most):
    contact = Contact((1, 2), (0, 1), friction, stiffness=2, preload=1)
    question = posed([contact], (0, 0, 0), max_displacement=most)
    cones = LineCones()
    relaxation = Relaxation(FloatContacts(question.rows), question.load, cones, most)
    states = {name: name for name in ("loose", "undecided", "detached", "attached", "stick")}
    states |= dict(zip(("slip+", "slip-"), cones.all, strict=True))
    for name, state in states.items():
        answers = []
        for x, y, c, t in product(
            (-2, 0, 1), (-2, 0, F(1, 2), 2), (0, 1, 5), (F(-5, 2), 0, F(1, 2))
        ):
            point = (F(x), F(y), F(0)), (F(c), F(t))
            answers.append(obeys(question, name, *point))
            assert obeys_in_floats(relaxation, state, *point) == answers[-1], (name, point)
        assert 0 < sum(answers) < len(answers)


@pytest.mark.parametrize("friction", [F(0), MU])
@pytest.mark.parametrize("cones", [RoundCones(), Pyramids(pyramid_edges(4))])
def test_cone_programs_in_space_hold_what_the_law_allows(friction, cones):
    """A force at its limit opposite to the slip; and forces too large, or off the spring."""
    contact = Contact((0, 0, 0), (0, 0, 1), friction, preload=1)
    question = posed([contact], (0,) * 6)
    relaxation = Relaxation(FloatContacts(question.rows), question.load, cones)
    is_round = isinstance(cones, RoundCones)
    sector = ((4, 1), (1, 4)) if is_round else cones.all[1]
    direction = (F(3, 5), F(4, 5)) if is_round else cones.all[1].edges[0]
    columns = zip(*contact.tangential_wrenches, strict=True)
    slipping = tuple(dot(direction, column) for column in columns)
    still = (F(0),) * 6
    for state, motion in (
        *((name, still) for name in ("loose", "undecided", "attached", "stick")),
        (sector, slipping),
    ):
        for share, pressed, allowed in (
            (-1, 1, True),
            (-1, 2, state in ("loose", "undecided")),
            (-2, 1, not friction),
            (-1, F(1, 2), state == "loose"),
        ):
            forces = pressed, *(friction * pressed * share * x for x in direction)
            assert obeys_in_floats(relaxation, state, motion, forces) == allowed, (state, forces)


def test_slips_of_pyramids_hold_on_their_sides_and_corners_alone():
    cones, contact = Pyramids(pyramid_edges(6)), Contact((0, 0, 0), (0, 0, 1), MU, preload=1)
    question = posed([contact], (0,) * 6)
    relaxation = Relaxation(FloatContacts(question.rows), question.load, cones)
    columns = list(zip(*contact.tangential_wrenches, strict=True))
    for slip in cones.all:
        along = [sum(column) for column in zip(*slip.ends, strict=True)]
        for edge, (way, size, obeyed) in product(
            slip.edges, ((1, 1, True), (-1, 1, False), (1, -1, False), (1, 2, False))
        ):
            motion = tuple(way * dot(along, column) for column in columns)
            forces = F(1), *(-size * MU * x for x in edge)
            state = cones.in_conditions(MU, slip)
            assert obeys(question, state, motion, forces) == obeyed
            assert obeys_in_floats(relaxation, slip, motion, forces) == obeyed
