"""The complete decision: known cases, properties, and brute force over all 4^m states."""

import json
from collections import Counter
from dataclasses import replace
from fractions import Fraction
from functools import partial

import pytest
from hypothesis import given, strategies as st

from arrangement.errors import InputError
from equilibrium import (
    Assembly,
    Contact,
    ContactModes,
    Grasp,
    GraspError,
    GraspWrenchSpace,
    ResistedSet,
    Verdict,
    compare,
    read_grasp,
    solve,
    solve_many,
    verify,
)
from equilibrium.decide import solver
from equilibrium.decide.solver import Solver
from equilibrium.grasps.inputs import random_grasp, random_wrench
from equilibrium.model.errors import UndecidedError

from . import oracle
from .agreement import disagreements
from .degenerate import BORDERS, GRASPS, Question, question
from .strategies import grasps, resisted, turned, wrenches

TINY = Fraction(1, 10**30)
THREE = read_grasp("paper-three-contacts-preload-1")
FOUR = read_grasp("paper-four-contacts-preload-1")


@given(grasps(4), wrenches)
def test_what_is_reported_is_true_and_proved(grasp, wrench):
    verdict = solve(grasp, wrench)
    for piece in verdict.equilibria:
        assert oracle.satisfies(grasp, wrench, piece.motion, piece.forces)
        assert piece.contains(piece.motion, piece.forces)
    assert verdict.verify()
    assert verdict.certificate.kind == ("resisted" if verdict.stable else "not resisted")


@given(grasps(4), st.lists(wrenches, min_size=1, max_size=4), st.sampled_from([None, 0, 1]))
def test_many_loads_have_single_verdicts_and_proofs(grasp, loads, most):
    found = list(Solver(grasp, max_displacement=most).solve_many(loads))
    for wrench, verdict in zip(loads, found, strict=True):
        assert verdict.wrench == tuple(wrench)
        assert verdict.stable == solve(grasp, wrench, max_displacement=most).stable
        assert verdict.verify()


def test_verify_takes_a_verdict_and_its_certificate():
    for wrench in ((0, 1, 0), (0, 2, 0)):
        verdict = solve(THREE, wrench)
        report = verify(verdict)
        assert (bool(report), report.kind, report.compared) == (True, verdict.verdict, True)
        assert verify(verdict.certificate)
        assert verify(verdict.certificate, (THREE, verdict.wrench)).compared
        assert not verify(verdict, (THREE, (Fraction(5), Fraction(0), Fraction(0))))
    with pytest.raises(UndecidedError, match="no certificate"):
        verify(replace(verdict, verdict="undecided"))


def test_forces_are_a_table_with_heads_and_unit(run, tmp_path):
    path = tmp_path / "grasp.json"
    path.write_text(json.dumps(THREE.with_units("mm", "N").to_dict()))
    head, *rows = run("solve {} --wrench 0 1 0", path).splitlines()[3:7]
    assert head == "               state     normal (N)  tangential (N)"
    assert rows[0] == "    contact 1  slip+     1           -1/2"
    assert rows[1] == "    contact 2  detached  0           0"
    load = ["--wrench", "0", "3/10", "2/5", "0", "0", "0"]
    head, row, *_ = run("solve two-opposed-fingers", *load).splitlines()[2:]
    assert head == "               state  normal  tangential"
    assert row == "    contact 1  stick  1       (-3/20, -1/5)"


def test_one_class_answers_for_a_grasp_and_for_bodies():
    grasp = solve(THREE, (0, 1, 0))
    bodies = solve(Assembly.of_grasp(THREE), {"object": (0, 1, 0)})
    assert type(grasp) is type(bodies) is Verdict
    assert (grasp.forces, bodies.forces) == (grasp.solution.forces, bodies.solution.forces)
    assert (grasp.grasp, bodies.grasp) == (THREE, bodies.assembly)
    assert bodies.wrench == bodies.wrenches == {"object": grasp.wrench}
    assert bodies.motions == {"object": bodies.solution.motion}
    for name, use in (
        ("assembly", "grasp"),
        ("wrenches", "wrench"),
        ("motions", "solution.motion"),
    ):
        with pytest.raises(AttributeError, match=f"'{name}'; use {use}$"):
            getattr(grasp, name)


def test_function_takes_wrenches_alone():
    found = solve_many(THREE, [(0, 1, 0), (0, 2, 0)])
    assert [verdict.stable for verdict in found] == [True, False]


def test_all_equilibria_of_few_contacts_in_the_plane_are_listed():
    held, refused = (solve(THREE, (0, y, 0)) for y in (1, 2))
    contact = next(iter(THREE))
    for count, few in ((20, True), (21, False)):
        many = replace(held, case=replace(held.case, subject=Grasp([contact] * count)))
        assert [many.lists_all(every) for every in (None, True, False)] == [few, True, False]
    in_space = Grasp([Contact([0, 0, 0], [0, 0, 1], 0)])
    assert not replace(held, case=replace(held.case, subject=in_space)).lists_all()
    assert refused.lists_all(False)
    assert not replace(refused, verdict="undecided").lists_all()


@pytest.mark.usefixtures("scrambled")
def test_processes_answer_in_order(monkeypatch):
    monkeypatch.setattr(solver, "_START_STEPS", 0)
    loads = [(0, Fraction(k, 40), 0) for k in range(60)]
    found = list(Solver(THREE).solve_many(loads, jobs=2))
    assert [verdict.stable for verdict in found] == [k <= 40 for k in range(60)]
    assert all(verdict.verify() for verdict in found[::17])
    with pytest.raises(InputError, match="jobs is 0; give 1 to"):
        Solver(THREE).solve_many(loads, jobs=0)


def test_processes_start_only_where_they_save_more(monkeypatch):
    monkeypatch.setattr(solver, "run_parts", lambda *_: pytest.fail("a process was started"))
    few = [(0, Fraction(k, 40), 0) for k in range(120)]
    assert len(list(Solver(THREE).solve_many(few, jobs=2))) == 120
    assert Solver(THREE)._processes(100_000, 1000, 2) == 2


def test_processes_change_no_answer_in_space(monkeypatch):
    monkeypatch.setattr(solver, "WRENCHES_PER_TASK", 4)
    monkeypatch.setattr(solver, "_START_STEPS", 0)
    loads = [(0,) * 6, *(random_wrench(k, dimension=3) for k in range(5))]
    asked = Solver(read_grasp("three-fingers-on-a-ball"))
    asked.solve(loads[-1])
    alone, shared = (list(asked.solve_many(loads, jobs=jobs)) for jobs in (1, 2))
    assert [x.verdict for x in alone] == [x.verdict for x in shared]
    assert len({x.verdict for x in alone}) == 2
    assert [x.certificate.text for x in alone] == [x.certificate.text for x in shared]


@given(resisted())
def test_pieces_are_maximal(question):
    pieces = solve(*question).equilibria
    assert pieces
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
    """States of a contact on the boundary of slip and stick hold a part of the solutions only."""
    grasp = read_grasp(name)
    pieces = solve(grasp, wrench).equilibria
    assert [piece.states for piece in pieces] == states
    for found in oracle.solutions(grasp, wrench):
        assert any(piece.contains(found.motion, found.forces) for piece in pieces)


def times(factor, vector):
    return tuple(factor * x for x in vector)


def moved(name, factor):
    """A change of a contact; what wrenches, motions and forces become."""

    def contact(c):
        changed = {name: factor * getattr(c, name)}
        return replace(c, **changed)

    load, motion = (factor, factor) if name == "preload" else (1, 1 / Fraction(factor))
    return contact, partial(times, load), partial(times, motion), partial(times, load)


def mirrored():
    def flip(v):
        return (-v[0], v[1], *(-x for x in v[2:]))

    def contact(c):
        return replace(c, point=flip(c.point), normal=flip(c.normal))

    return contact, flip, flip, lambda pair: (pair[0], -pair[1])


@pytest.mark.parametrize(
    "law",
    [
        moved("preload", 10**20),
        moved("preload", Fraction(1, 3)),
        moved("stiffness", 3),
        turned(0, 1),
        turned(Fraction(-5, 13), Fraction(12, 13)),
        turned(Fraction(3, 5), Fraction(4, 5), -3, 2),
        mirrored(),
    ],
)
@given(grasp=grasps(), wrench=wrenches)
def test_equilibria_follow_a_change_of_units_and_frames(law, grasp, wrench):
    contact, load, motion, force = law
    before = solve(grasp, wrench).equilibria
    after = solve(Grasp(map(contact, grasp)), load(wrench)).equilibria
    assert len(before) == len(after)
    carried = {(motion(p.motion), tuple(map(force, p.forces))) for p in before}
    if not any(motion((0, 0, 1))[:2]):  # the least motion depends on the origin
        assert carried == {(p.motion, p.forces) for p in after}
    assert all(any(p.contains(*one) for p in after) for one in carried)


@given(grasps(), wrenches, st.randoms(use_true_random=False))
def test_order_of_contacts_does_not_matter(grasp, wrench, random):
    order = list(range(len(grasp)))
    random.shuffle(order)
    shuffled = solve(Grasp(grasp.contacts[i] for i in order), wrench).equilibria
    before = solve(grasp, wrench).equilibria
    assert {(p.motion, tuple(p.forces[i] for i in order)) for p in before} == {
        (p.motion, p.forces) for p in shuffled
    }


def test_polytope_of_forces_has_exact_ranges_and_least_forces():
    (piece,) = solve(FOUR, (0, 0, 0)).equilibria
    half = Fraction(1, 2)
    assert piece.forces == ((1, 0),) * 4
    assert piece.force_ranges == (((1, 1), (-half, half)),) * 4
    assert not piece.unique


def test_detached_contacts_leave_the_motion_free():
    (piece,) = solve(FOUR.with_preload(0), (0, 0, 3)).equilibria
    assert piece.states == ("slip-", "detached", "slip-", "detached")
    assert piece.forces_determined
    assert piece.motion_ranges == ((0, 0), (-1, 1), (1, 1))
    assert piece.contains((0, -1, 1), [(1, "1/2"), (0, 0), (1, "1/2"), (0, 0)])
    assert piece.motion == (0, 0, 1)


def test_object_may_run_away_from_all_contacts():
    grasp = Grasp([Contact((0, 0), (1, 0), 1, 1, 1)])
    (piece,) = solve(grasp, (0, 0, 0)).equilibria
    assert piece.states == ("detached",)
    assert piece.motion == (1, 0, 0)
    assert piece.motion_ranges[0] == (1, None)
    assert piece.motion_ranges[2] == (None, None)


def test_no_contacts_hold_nothing_but_the_zero_wrench():
    assert solve(Grasp(), (0, 0, 0)).stable
    for wrench in ((1, 0, 0), (0, 0, -TINY)):
        verdict = solve(Grasp(), wrench)
        assert not verdict.stable
        assert verdict.verify()


def test_coincident_contacts_share_the_load():
    one, two = Contact((0, 0), (0, 1), 1), Contact((0, 0), (0, 1), 1, 3)
    (piece,) = solve(Grasp([one, two]), (0, -4, 0)).equilibria
    assert [normal for normal, _ in piece.forces] == [1, 3]


@pytest.mark.parametrize("dimension", [2, 3])
def test_numbers_beyond_floats_have_verdicts_and_no_warnings(dimension):
    tiny = Fraction(10) ** -320
    grasp = random_grasp(3, 0, dimension=dimension, preload=dimension == 2)
    soft = Grasp([replace(grasp.contacts[0], stiffness=tiny), *grasp.contacts[1:]])
    load = [1] * (3 * dimension - 3)
    for verdict in (solve(soft, load), solve(grasp, [tiny * x for x in load])):
        assert verdict.stable is not None


def test_wrong_wrench_is_refused():
    for wrench in ((0, 0), (0, 0, 0.5), "123", (0, 0, True)):
        with pytest.raises(ValueError, match="wrench"):
            solve(THREE, wrench)


def test_wrong_question_to_contains_is_refused():
    (piece,) = solve(THREE, (0, 0, 0)).equilibria
    with pytest.raises(GraspError, match="pairs"):
        piece.contains((0, 0, 0), [(0, 0)])


CHUNK = 8


@pytest.mark.parametrize(
    "chunk", [0, *(pytest.param(k, marks=pytest.mark.slow) for k in range(1, 5))]
)
def test_solver_agrees_with_brute_force(chunk):
    for seed in range(CHUNK * chunk, CHUNK * (chunk + 1)):
        assert disagreements(question(seed)) == [], seed


@given(grasps(), wrenches)
def test_solver_agrees_on_a_coarse_grid(grasp, wrench):
    assert disagreements(Question(0, grasp, wrench, "grid", "free")) == []


def test_motion_bound_is_the_largest_component():
    """One spring of stiffness 1 without friction under the load 12 gives way by 12."""
    grasp, wrench = Grasp([Contact((0, 0), (0, 1), 0)]), (Fraction(0), Fraction(-12), Fraction(0))
    assert oracle.is_stable(grasp, wrench)
    assert oracle.is_stable(grasp, wrench, bound=12)
    assert not oracle.is_stable(grasp, wrench, bound=Fraction(119, 10))


def test_cancelling_forces_refuted_by_other_balances():
    """With slip- the friction torques of the two contacts cancel, whatever the motion."""
    normal, half = (Fraction(1), Fraction(0)), Fraction(1, 2)
    grasp = Grasp([Contact((-1, 0), normal, 1), Contact((1, 0), normal, half, 2)])
    verdict = solve(grasp, (2, Fraction(3, 2), 0))
    assert not verdict.stable
    assert verdict.verify()


def test_questions_are_of_all_kinds():
    asked = [question(seed) for seed in range(24)]
    assert Counter(len(q.grasp) for q in asked) == {2: 6, 3: 6, 4: 6, 5: 6}
    assert {q.kind for q in asked} == set(GRASPS)
    assert {q.load for q in asked} == {"free", "zero", *BORDERS}


@pytest.mark.parametrize(
    "ask",
    [
        partial(solve, wrench=[0, -1, 0]),
        partial(compare, wrench=[0, -1, 0]),
        ResistedSet,
        GraspWrenchSpace,
        ContactModes.of_grasp,
    ],
)
@pytest.mark.parametrize(
    ("value", "remedy"),
    [
        ("ladder", "the grasp is 'ladder'; .* Write read_grasp('ladder')"),
        ({"contacts": []}, "Write read_grasp(document)"),
        ([], "Write Grasp(contacts)"),
        (None, "the grasp is None; .* Write Grasp(contacts)"),
    ],
)
def test_other_values_are_not_grasps(ask, value, remedy):
    with pytest.raises(GraspError, match=remedy.replace("(", r"\(").replace(")", r"\)")):
        ask(value)
