"""Force closure with round cones: a proof either way, and the check that it passes."""

import re
import sys
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from random import Random
from types import ModuleType

import numpy as np
import pytest

from arrangement.errors import MissingExtraError
from arrangement.numbers.exact import dot
from equilibrium import Contact, Grasp, GraspWrenchSpace, check_grasps, read_grasp
from equilibrium.certificate.law import closure_problem, escape_problem
from equilibrium.core.contact_rows import cone_edge, friction_edges
from equilibrium.grasps.inputs.random import random_grasp
from equilibrium.methods import closure_friction, compare, force_closure
from equilibrium.methods.closure_friction import closure_frictions
from equilibrium.methods.form_closure import _ray_value, form_closure
from equilibrium.methods.round_cones import separates
from equilibrium.model.contact import pyramid_edges
from equilibrium.model.errors import GraspError, UndecidedError

HALF = Fraction(1, 2)
#: Closed by round cones, and not by pyramids of 4 edges in the frames of these contacts.
TRIANGLE = [
    (["0.7", -1, "0.7"], [0, 1, 0]),
    (["0.35", 1, "-0.35"], [0, -1, 0]),
    (["-0.35", 1, "0.35"], [0, -1, 0]),
]
#: At friction 1/2 the last two are seen by the first just along an edge of its cone.
ROW = [([-1, 0, 0], [1, 0, 0]), ([1, 1, 0], [-1, 0, 0]), ([1, 2, 0], [-1, 0, 0])]
TURNS = [(1, 0, 0, 0), (1, 2, 3, 4), (5, 1, -2, 3), (3, 1, 1, 0)]


def fingers(places, friction="3/5", turn=(1, 0, 0, 0)):
    """Contacts turned by a quaternion of integers."""
    a, b, c, d = map(Fraction, turn)
    size = a * a + b * b + c * c + d * d
    rows = [
        (a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)),
        (2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)),
        (2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d),
    ]

    def turned(v):
        return [dot(row, [Fraction(x) for x in v]) / size for row in rows]

    return Grasp(Contact(turned(point), turned(normal), friction) for point, normal in places)


def polyhedral(grasp, edges):
    """Whether cones with these edges have force closure, by Liu's program."""
    value = _ray_value([cone_edge(c, x) for c in grasp for x in edges] if len(grasp) else [])
    return value is not None and value < 1


def around(count):
    """Corners of a polygon around the unit circle."""
    edges = pyramid_edges(count)
    return [
        tuple((x + y) / (1 + dot(u, v)) for x, y in zip(u, v, strict=True))
        for u, v in pairwise((*edges, edges[0]))
    ]


def check(grasp):
    """The answer, with its proof checked."""
    found = force_closure(grasp)
    if found.accepts:
        assert not closure_problem(grasp, found.forces)
    elif found.accepts is False:
        assert not escape_problem(grasp, found.free_motion)
    return found.accepts


@pytest.mark.parametrize("turn", TURNS)
def test_the_frame_of_a_grasp_does_not_matter(turn):
    assert check(fingers(TRIANGLE, "0.6", turn)) is True
    assert check(fingers(TRIANGLE, "0.35", turn)) is False
    # On the boundary along a rational direction of friction.
    assert [check(fingers(ROW, mu, turn)) for mu in ("0.49", "1/2", "0.51")] == [False, False, True]


def test_linearised_cones_prove_no_contrary():
    grasp = fingers(TRIANGLE)
    space = GraspWrenchSpace(grasp)
    assert not space.surrounds_origin
    assert space.epsilon_squared == 0
    assert space.force_closure is True
    with pytest.raises(GraspError, match="force_closure"):
        form_closure(grasp, friction=True)


@pytest.mark.parametrize("friction", [0, "1/2", 7, 10**6])
def test_two_point_contacts_turn_about_their_line(friction):
    pair = fingers([([-1, 0, 0], [1, 0, 0]), ([1, 0, 0], [-1, 0, 0])], friction, (1, 2, 3, 4))
    assert check(pair) is False
    assert check(Grasp(pair.contacts[:1])) is False


def test_no_contacts_have_no_force_closure():
    assert check(Grasp([])) is False


@pytest.mark.parametrize("friction", ["0.35", "0.6"])
def test_adhesion_changes_no_cone(friction):
    grasp = fingers(TRIANGLE, friction)
    assert check(grasp.with_adhesion(100)) is check(grasp)


def test_the_boundary_is_narrow_and_monotone():
    low, high = Fraction(0), Fraction(4)
    grasp = fingers(TRIANGLE)
    while True:
        middle = (low + high) / 2
        closed = check(grasp.with_friction(middle))
        if closed is None:
            break
        low, high = (low, middle) if closed else (middle, high)
    assert high - low < Fraction(1, 10**5)
    with pytest.raises(UndecidedError, match="close to its boundary"):
        bool(force_closure(grasp.with_friction(middle)))


def random_question(k):
    source = Random(k)
    grasp = random_grasp(source.choice([3, 3, 4, 4, 5, 6]), k, dimension=3)
    if k % 3 == 0:
        return grasp.with_friction(Fraction(source.randint(0, 8), 4))
    if k % 3 == 1:
        normals = [(s * (i == 0), s * (i == 1), s * (i == 2)) for i in range(3) for s in (1, -1)]
        normals += [(Fraction(3, 5), Fraction(4, 5), 0)]
        return Grasp(
            Contact(
                [source.randint(-2, 2) for _ in range(3)],
                source.choice(normals),
                source.choice([0, HALF, 1, 2]),
            )
            for _ in grasp
        )
    return grasp


def agree_with_polyhedra(k, count):
    grasp = random_question(k)
    closed = check(grasp)
    if polyhedral(grasp, pyramid_edges(count)):
        assert closed is True
    if not polyhedral(grasp, around(count)):
        assert closed is False


def test_answers_agree_with_pyramids_inside_and_around():
    for k in range(25):
        agree_with_polyhedra(k, 12)


@pytest.mark.slow
def test_many_answers_agree_with_pyramids_inside_and_around():
    for k in range(100, 700):
        agree_with_polyhedra(k, 24)


class TestChecker:
    @pytest.mark.parametrize(
        ("change", "problem"),
        [
            (lambda f: f[:2], "one force"),
            (lambda f: [(2 * f[0][0], *f[0][1:]), *f[1:]], "add up to"),
            (lambda f: [(f[0][0], 10 * f[0][0], 0), *f[1:]], "contact 1: .* strictly inside"),
            (lambda f: [(-1, 0, 0), *f[1:]], "contact 1: .* strictly inside"),
            (lambda f: [(0, 0, 0)] * 3, "span 0 of 6"),
        ],
    )
    def test_changed_forces_are_refused(self, change, problem):
        grasp = fingers(TRIANGLE)
        forces = force_closure(grasp).forces
        assert re.search(problem, closure_problem(grasp, change(forces)))

    def test_forces_on_the_boundary_of_cones_are_refused(self):
        grasp = fingers(ROW, HALF)
        forces = [(Fraction(4), Fraction(2), Fraction(0)), (Fraction(4), Fraction(-2), Fraction(0))]
        assert "strictly inside" in closure_problem(Grasp(grasp.contacts[:2]), forces)

    def test_contacts_without_a_force_are_not_needed(self):
        grasp = fingers(TRIANGLE)
        more = Grasp([*grasp, Contact([0, 0, 5], [0, 0, 1], 0)])
        zero = (Fraction(0),) * 3
        assert not closure_problem(more, [*force_closure(grasp).forces, zero])

    def test_motions_that_forces_oppose_are_refused(self):
        grasp = fingers(ROW, HALF)
        motion = force_closure(grasp).free_motion
        assert "contact" in escape_problem(grasp, [-x for x in motion])
        assert "other than 0" in escape_problem(grasp, [Fraction(0)] * 6)
        assert "6 numbers" in escape_problem(grasp, motion[:3])

    def test_an_escape_separates_a_load(self):
        grasp = fingers(ROW, "0.49")
        load = [sum(column) for column in zip(*(c.normal_wrench for c in grasp), strict=True)]
        assert separates(grasp, grasp.total_load(load), force_closure(grasp).free_motion)


def test_without_the_cone_programs_pyramids_decide_or_the_extra_is_named(monkeypatch):
    def missing(_):
        raise MissingExtraError("clarabel is not installed")

    search = ModuleType("equilibrium.methods.closure_search")
    monkeypatch.setattr(search, "__getattr__", missing, raising=False)
    monkeypatch.setitem(sys.modules, search.__name__, search)
    assert check(fingers(TRIANGLE)) is True
    assert check(fingers(TRIANGLE, "0.35")) is False
    with pytest.raises(MissingExtraError, match="clarabel"):
        force_closure(fingers(ROW, HALF, (1, 2, 3, 4)))


class TestCommand:
    @pytest.fixture
    def path(self, tmp_path):
        path = tmp_path / "triangle.csv"
        rows = [",".join(map(str, (*point, *normal, "0.6"))) for point, normal in TRIANGLE]
        path.write_text("\n".join(["x,y,z,nx,ny,nz,mu", *rows]) + "\n", encoding="utf-8")
        return str(path)

    def test_round_cones_decide(self, path, run):
        assert "force closure    yes (round cones, proved)\n" in run("info", path)
        text = run("info {} --force-closure", path)
        assert text.startswith("force closure    yes (round cones, proved)\n")
        assert "linearised space friction pyramids of 4 edges, inside the round cones:\n" in text
        document = run.json("info {} --force-closure", path)
        assert (document["force_closure"], document["epsilon_squared"]) == (True, "0")
        forces = [tuple(map(Fraction, force)) for force in document["balanced_forces"]]
        assert not closure_problem(fingers(TRIANGLE), forces)

    def test_a_no_has_a_motion(self, run):
        text = run("info two-opposed-fingers --force-closure", code=1)
        assert "free motion      (0, 0, 0, 1, 0, 0): no contact force opposes it\n" in text
        assert run.json("info two-opposed-fingers")["free_motion"] == ["0", "0", "0", "1", "0", "0"]

    def test_a_large_hull_hides_no_answer(self, run):
        text = run("info peg-in-a-hole --force-closure")
        assert "force closure    yes (round cones, proved)" in text
        assert "epsilon          not computed: the hull of 6 contacts" in text

    def test_methods_name_the_linearised_space(self):
        answer = compare(fingers(TRIANGLE), (0, 0, 0, 0, 1, 0))["wrench-space"]
        assert answer.accepts
        assert "force closure" in answer.remark
        assert "pyramids of 4 edges" in answer.remark
        forced = compare(fingers(TRIANGLE), (0, 0, 0, 0, 1, 0), pyramid=4)["wrench-space"]
        assert forced.remark.startswith("pyramids of 4 edges")


def test_friction_edges_in_the_plane_give_the_same():
    for name in ("paper-three-contacts", "opposed-contacts", "single-contact", "ladder"):
        grasp = read_grasp(name)
        edges = [edge for contact in grasp for edge in friction_edges(contact)]
        value = _ray_value(edges)
        assert check(grasp) is (value is not None and value < 1)


ENDS = [([-1, 0], ["12/13", "5/13"]), ([1, 0], ["-12/13", "5/13"])]
#: Three fingers that press inwards and upwards, 5/12 off the horizontal: up is free below that.
TRIPOD = [
    (["4", "3", "0"], ["-48/65", "-36/65", "5/13"]),
    (["-4", "3", "0"], ["48/65", "-36/65", "5/13"]),
    (["0", "-5", "0"], ["0", "12/13", "5/13"]),
]


@pytest.mark.parametrize(
    ("places", "least"),
    [
        (ENDS, Fraction(5, 12)),
        (TRIPOD, Fraction(5, 12)),
        # The two sides see each other at 0.35 sqrt(2) off their normals.
        (TRIANGLE, Fraction(49 * 2, 400)),
    ],
)
def test_least_friction_for_closure_by_hand(places, least):
    grasp = Grasp(Contact(point, normal, 1) for point, normal in places)
    found = closure_friction(grasp, "1/100000")
    assert not found.impossible
    assert found.verify(grasp)
    assert found.high - found.low <= Fraction(1, 100000)
    if places is TRIANGLE:
        assert found.low**2 <= least < found.high**2
    else:
        assert found.low == least < found.high


def test_least_friction_of_the_antipodal_pair_at_20_degrees(tmp_path, run):
    """Nguyen: each cone has to hold the other finger, so it is tan 20 = 0.36397."""
    table = tmp_path / "pair.csv"
    table.write_text("x,y,angle,mu\n-1,0,20,0.5\n1,0,160,0.5\n")
    assert "least friction   0.36397 (between " in run("info {} --force-closure", table)
    printed = run("info two-opposed-fingers --force-closure", code=1)
    assert "least friction   none is enough (the same at all contacts), proved" in printed


def test_no_friction_closes_two_fingers_in_space():
    grasp = read_grasp("two-opposed-fingers")
    found = closure_friction(grasp)
    assert (found.impossible, found.high) == (True, None)
    assert found.verify(grasp)
    form = Grasp(
        Contact(point, normal, 0)
        for point, normal in [
            ([-1, 1], [1, 0]),
            ([1, -1], [-1, 0]),
            ([1, -1], [0, 1]),
            ([-1, 1], [0, -1]),
        ]
    )
    closed = closure_friction(form)
    assert (closed.low, closed.high, closed.verify(form)) == (0, 0, True)
    with pytest.raises(GraspError, match="tolerance is 0; it must be above 0"):
        closure_friction(form, 0)


def test_brackets_of_many_grasps_are_rounded_outwards():
    grasps = [
        Grasp(Contact([x, 0], [-x * q, p], 1) for x in (-1, 1))
        for p, q in (
            (Fraction(2 * t, 1 + t * t), (1 - t * t) / (1 + t * t))
            for t in (Fraction(1, k) for k in range(3, 11))
        )
    ]
    down = up = 0
    for grasp, ends in zip(grasps, closure_frictions(grasps, "1/50"), strict=True):
        low, high = map(Fraction, ends)
        exact = closure_friction(grasp, "1/50")
        assert low <= exact.low < exact.high <= high
        assert exact.low <= Fraction(np.nextafter(ends[0], 1))
        assert Fraction(np.nextafter(ends[1], 0)) <= exact.high
        down += Fraction(float(exact.low)) > exact.low
        up += Fraction(float(exact.high)) < exact.high
    assert down
    assert up


@pytest.mark.parametrize("dimension", [2, 3])
def test_closure_changes_at_the_least_friction(dimension):
    found = {True: 0, False: 0}
    for seed in range(12):
        grasp = random_grasp(4, seed, dimension=dimension)
        least = closure_friction(grasp, "1/1000")
        found[least.impossible] += 1
        assert least.verify(grasp)
        if least.impossible:
            assert force_closure(grasp.with_friction(1000)).accepts is not True
            continue
        assert force_closure(grasp.with_friction(least.high)).accepts is not False
        assert force_closure(grasp.with_friction(least.high * Fraction(9, 8))).accepts
        if least.low:
            assert not force_closure(grasp.with_friction(least.low * Fraction(7, 8))).accepts
            for forged in ({"low": least.high * 2}, {"high": least.low / 2}):
                assert not replace(least, **forged).verify(grasp)
    assert found[False] > 5


def test_labels_of_arrays_of_grasps():
    turn = np.radians(20)
    normals = [[[np.cos(turn), np.sin(turn)], [-np.cos(turn), np.sin(turn)]], [[0, 1], [0, 1]]]
    checked = check_grasps([[[-1, 0], [1, 0]]] * 2, normals, 0.5, [[0, -1, 0]])
    (low, high), never = checked.closure_friction("1/100000")
    assert low <= np.tan(turn) + 1e-9
    assert high >= np.tan(turn) - 1e-9
    assert high - low <= 1.1e-5
    assert never.tolist() == [np.inf, np.inf]
