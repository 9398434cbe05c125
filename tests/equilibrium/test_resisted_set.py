"""Each method of `ResistedSet` against the function that computes it, and what stays undecided."""

import math
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

import equilibrium
from arrangement.numbers.linear.intervals import holds
from equilibrium import (
    Certificate,
    Contact,
    Grasp,
    ResistedSet,
    read_grasp,
    solve,
    solve_many,
    verify,
)
from equilibrium.decide.solver import Solver
from equilibrium.grasps.inputs import from_float_data, on_circle
from equilibrium.model.errors import GraspError, UndecidedError
from equilibrium.wrench_sets.along_in_space import spatial_magnitudes
from equilibrium.wrench_sets.friction import least_friction
from equilibrium.wrench_sets.line import margin, resisted_magnitudes, sufficient_preloads
from equilibrium.wrench_sets.polyhedra import resisted_pieces, states_with
from equilibrium.wrench_sets.search_map import search_map
from equilibrium.wrench_sets.slice import resisted_region
from proofs_check.instances.grasps import grasp_of
from proofs_check.routes import oracle
from proofs_check.routes.oracle import Question

PAPER = [
    f"paper-{number}-contacts{preload}"
    for number in ("three", "four")
    for preload in ("", "-preload-1")
]
WRENCHES = [(0, 0, 0), (0, 1, 0), (0, -1, 0), (1, 0, 0), (0, "3/2", 0), (0, 0, "1/4"), (1, -2, 1)]
UP = (0, 1, 0)


@pytest.fixture(params=PAPER)
def grasp(request):
    return read_grasp(request.param)


def test_membership_is_that_of_verdicts_and_polyhedra(grasp):
    resisted = ResistedSet(grasp)
    assert resisted.polyhedra == resisted_pieces(Solver(grasp))
    assert resisted.polyhedra is resisted.polyhedra
    expected = [solve(grasp, wrench).stable for wrench in WRENCHES]
    assert [wrench in resisted for wrench in WRENCHES] == expected
    assert [resisted.contains(wrench) for wrench in WRENCHES] == expected
    assert [resisted.solve(wrench).stable for wrench in WRENCHES] == expected
    assert [verdict.stable for verdict in resisted.solve_many(WRENCHES)] == expected
    assert [verdict.stable for verdict in solve_many(grasp, WRENCHES)] == expected
    loads = np.array([[float(Fraction(x)) for x in wrench] for wrench in WRENCHES])
    assert resisted.check(loads).resisted.tolist() == expected
    exact = [tuple(map(Fraction, wrench)) for wrench in WRENCHES]
    assert [bool(states_with(resisted.polyhedra, w)) for w in exact] == expected


@pytest.mark.parametrize("grasp", [PAPER[0], PAPER[3]], indirect=True)
def test_other_queries_are_those_of_the_functions(grasp):
    resisted, wrench, torque = ResistedSet(grasp), (0, "3/2", 0), (0, 0, 1)
    assert resisted.along(UP) == resisted_magnitudes(grasp, UP)
    assert resisted.along(UP, (1, 0, 0)) == resisted_magnitudes(grasp, UP, (1, 0, 0))
    assert resisted.slice().polygons == resisted_region(grasp).polygons
    plane = resisted_region(grasp, (UP, torque), (1, 0, 0))
    assert resisted.slice(UP, torque, (1, 0, 0)).to_dict() == plane.to_dict()
    found = resisted.margin(wrench)
    assert found == margin(grasp, wrench)
    assert found.preloads == sufficient_preloads(grasp, wrench)
    assert found.friction("1/1000") == least_friction(grasp, wrench, "1/1000")
    assert resisted.search(rays=8, tolerance="1/10") == search_map(grasp, 8, "1/10")
    pieces = [piece.to_dict() for piece in resisted.polyhedra]
    assert resisted.to_dict() == {"polyhedra": pieces}


def test_smallest_wrench_outside():
    resisted = ResistedSet(read_grasp("paper-three-contacts-preload-1"))
    found = resisted.smallest_outside()
    assert (found.size_squared, found.wrench) == (
        Fraction(4, 9),
        (Fraction(2, 9), Fraction(4, 9), Fraction(-4, 9)),
    )
    assert resisted.smallest_outside((0, 2, 0)).size_squared == 0
    assert resisted.smallest_outside(torque_length=2).size_squared < Fraction(4, 9)


def test_bounded_displacements_hold_in_every_query():
    grasp = read_grasp("paper-three-contacts-preload-1")
    resisted, solver = ResistedSet(grasp, max_displacement="1/10"), Solver(grasp, "1/10")
    wrench = ("1/2", 1, "1/4")
    assert resisted.max_displacement == Fraction(1, 10)
    assert resisted.polyhedra == resisted_pieces(solver) != ResistedSet(grasp).polyhedra
    assert resisted.along(wrench) == resisted_magnitudes(solver, wrench)
    assert resisted.slice().polygons == resisted_region(solver).polygons
    assert resisted.margin(wrench).preloads == sufficient_preloads(solver, wrench)
    assert (wrench in resisted) == solver.solve(wrench).stable
    with pytest.raises(GraspError, match="bounded displacements is not drawn"):
        resisted.draw()


def test_construction_computes_nothing(monkeypatch):
    def refuse(*_: object) -> None:
        raise AssertionError

    for name in ("choices", "solve"):
        monkeypatch.setattr(Solver, name, property(refuse))
    resisted = ResistedSet(read_grasp("paper-four-contacts"))
    assert set(vars(resisted)) == {"_solver"}
    assert repr(resisted) == "<ResistedSet: grasp <Grasp: 4 contacts>>"
    with pytest.raises(GraspError, match="even number"):
        ResistedSet(read_grasp("wedge"), pyramid=3)


def test_spatial_grasps_answer_what_is_known():
    grasp, along = read_grasp("two-opposed-fingers"), (0, 1, 0, 0, 0, 0)
    resisted = ResistedSet(grasp)
    found = resisted.along(along)
    assert found == spatial_magnitudes(grasp, along)
    assert found.borders[0].resisted == 1
    assert (0, "3/5", "4/5", 0, 0, 0) in resisted
    assert (0, 2, 0, 0, 0, 0) not in resisted
    assert [v.stable for v in resisted.solve_many([along, [2 * x for x in along]])] == [True, False]
    queries = [
        lambda: resisted.polyhedra,
        lambda: resisted.check(np.zeros((1, 6))),
        lambda: resisted.slice(),
        lambda: resisted.margin(along),
        resisted.search,
        resisted.smallest_outside,
    ]
    for query in queries:
        with pytest.raises(GraspError, match="in space"):
            query()
    with pytest.raises(GraspError, match="pyramid is 4; magnitudes along"):
        ResistedSet(grasp, pyramid=4).along(along)


def test_membership_raises_where_space_is_undecided():
    resisted, wrench = ResistedSet(read_grasp("peg-in-a-hole")), (0, 0, "-3/2", 0, 0, 0)
    undecided = resisted.solve(wrench, nodes=1)
    resisted.solve = lambda _: undecided
    with pytest.raises(UndecidedError, match="after 1 nodes"):
        wrench in resisted  # noqa: B015


def test_membership_raises_where_rounding_decides():
    """A frictionless disc turns under any torque, unless its data are rounded one by one."""
    out = [(math.cos(angle), math.sin(angle)) for angle in map(math.radians, [160, 290, 50])]
    points, normals = [[0.03 * x, 0.03 * y] for x, y in out], [[-x, -y] for x, y in out]
    resisted = ResistedSet(from_float_data(points, normals, 0.0, as_given=True).grasp)
    turning = (0, 0, 1)
    assert resisted.solve(turning).stable
    with pytest.raises(UndecidedError, match=r"\(0, 0, 1\) is resisted depends on the rounding"):
        turning in resisted  # noqa: B015
    exact = ResistedSet(from_float_data(points, normals, 0.0).grasp)
    assert turning not in exact


def test_solve_as_printed_takes_no_other_option():
    grasp = read_grasp("single-contact")
    assert not solve(grasp, (1, 0, 0), as_printed=["signs"]).stable
    with pytest.raises(GraspError, match="as_printed takes no time_limit"):
        solve(grasp, (0, 0, 0), as_printed=[], time_limit=1)
    with pytest.raises(GraspError, match="as_printed takes no shorten"):
        solve(grasp, (0, 0, 0), as_printed=[], shorten=True)


def test_a_saved_certificate_is_verified(tmp_path):
    verdict = solve(read_grasp("single-contact"), (1, 0, 0))
    certificate = verdict.certificate
    assert isinstance(certificate, Certificate)
    certificate.save(tmp_path / "proof.json")
    assert verify(tmp_path / "proof.json", (verdict.grasp, verdict.wrench))
    assert verify(certificate.to_dict())


@pytest.mark.parametrize(
    ("owner", "name", "hint"),
    [
        (equilibrium, "force_closure", "GraspWrenchSpace(grasp).force_closure"),
        (equilibrium, "from_float_data", "equilibrium.inputs.from_float_data"),
        (equilibrium, "margin", "ResistedSet(grasp).margin(wrench)"),
        (equilibrium, "check", "verify(source)"),
        (equilibrium, "Contakt", "Contact"),
        (read_grasp("single-contact"), "plot", "draw()"),
        (read_grasp("single-contact"), "contact", "contacts"),
        (solve(read_grasp("single-contact"), (1, 0, 0)), "resisted", "stable"),
        (ResistedSet(read_grasp("single-contact")), "sufficient_preloads", "margin(wrench).pre"),
    ],
)
def test_missing_names_are_answered(owner, name, hint):
    with pytest.raises(AttributeError, match=f"has no attribute '{name}'; use ") as error:
        getattr(owner, name)
    assert hint in str(error.value)


def test_answers_to_many_loads_are_summed_up():
    grasp = read_grasp("paper-three-contacts-preload-1")
    assert repr(ResistedSet(grasp).check([[0, 1, 0], [0, 2, 0], [0, -1, 0]])) == (
        "<CheckedLoads: 3 loads, 2 resisted, 1 decided in fractions>"
    )


CONSTANT = [
    ((-1, 0, 1, 0, "1/2", 0, 2), (1, 0, -1, 0, "1/2", 1, 0)),
    ((-1, 0, 1, 0, "1/2", 0, 2), (0, -1, 0, 1, 1, 2, 1), (1, 1, "-3/5", "-4/5", 1, 0, 1)),
    ((0, 0, 1, 0, 1, 0, 0), (1, 0, -1, 0, 1, 1, 1)),
    ((0, 0, 0, 1, "1/2", 0, 3),),
]


@pytest.mark.parametrize("rows", CONSTANT, ids=len)
@pytest.mark.parametrize("wrench", [(0, 0, 0), (0, 1, 0), (-1, -1, 1), (1, 0, 0), (0, -3, 0)])
def test_constant_force_is_held_as_by_elimination(rows, wrench):
    """Contacts with stiffness 0 press with their preload wherever the object moves."""
    contacts = tuple(tuple(map(Fraction, row)) for row in rows)
    asked = Question(contacts, tuple(map(Fraction, wrench)))
    grasp = grasp_of(asked)
    verdict = solve(grasp, wrench)
    assert verdict.verify()
    assert verdict.stable == oracle.stable(asked)
    if verdict.stable:
        pushes = {i: f[0] for i, f in enumerate(verdict.solution.forces)}
        assert all(pushes[i] == c.preload for i, c in enumerate(grasp) if not c.stiffness)
    if any(wrench):
        exact = [end for end in oracle.resisted(asked) if end[1] is None or end[1] >= 0]
        found = ResistedSet(grasp).along(wrench).intervals
        assert found == tuple((max(low or Fraction(0), Fraction(0)), high) for low, high in exact)


def test_constant_force_is_not_bounded(tmp_path, refused):
    path = tmp_path / "a.json"
    Grasp([Contact((-1, 0), (1, 0), 1, 0, 2), Contact((1, 0), (-1, 0), 1)]).save(path)
    load = ["--wrench", "0", "1", "0"]
    for words, said in (
        (["solve", str(path), *load, "--robust", "friction=5%"], "stiffness 0"),
        (["lab", str(path), "-o", str(tmp_path / "lab.html")], "stiffness 0"),
        (["draw", str(path), "--model", "scene", "-o", str(tmp_path / "s.xml")], "stiffness 0"),
    ):
        assert said in refused(*words)


def test_constant_force_is_for_the_plane():
    assert Contact([0, 0], [1, 0], 1, 0, 2).stiffness == 0
    with pytest.raises(GraspError, match="above 0 in space"):
        Contact([0, 0, 0], [1, 0, 0], 1, 0, 2)
    with pytest.raises(GraspError, match="at least 0"):
        Contact([0, 0], [1, 0], 1, -1, 2)


LOADS = ((0, 3, 0), (1, -1, 0), (0, 0, "1/2"))


@pytest.mark.parametrize(
    "name", ["paper-four-contacts", "paper-three-contacts", "all-contacts-stick"]
)
@pytest.mark.parametrize("contacts", [(1,), (1, 3), (2, 3)])
def test_preloads_of_chosen_contacts_resist_every_load(name, contacts):
    grasp = read_grasp(name)
    found = ResistedSet(grasp).preloads(LOADS, contacts)
    ends = sorted({x for part in found.intervals for x in part if x is not None} | {Fraction(7)})
    tried = {Fraction(0), *ends, *(x + Fraction(1, 97) for x in ends)}
    tried |= {x - Fraction(1, 97) for x in ends if x > Fraction(1, 97)}
    for p in tried:
        chosen = Grasp(
            replace(c, preload=p) if i in contacts else c for i, c in enumerate(grasp, 1)
        )
        held = all(solve(chosen, w).stable for w in LOADS)
        assert held == holds(found.intervals, p), p


def test_preloads_of_all_contacts_are_those_of_the_margin():
    resisted = ResistedSet(read_grasp("paper-three-contacts"))
    load = (0, 3, 0)
    assert resisted.preloads([load]).intervals == resisted.margin(load).preloads.intervals
    for wrong in ([], [0], [4]):
        with pytest.raises(GraspError, match="numbers of contacts from 1 to 3"):
            resisted.preloads([load], wrong)


def test_candidates_on_a_disc(tmp_path, run):
    """12 contacts around a disc that stands on one: those above it can hold a push up."""
    angles = [Fraction(x) for x in range(0, 360, 30)]
    disc = on_circle([float(a) for a in angles], "1/2", radius=1, preload=1).grasp
    below = read_grasp("paper-three-contacts-preload-1")
    sets = ResistedSet(below).with_contact(disc)
    held = [(0, 2, 0) in found for found in sets]
    assert held == [solve(Grasp([*below, c]), (0, 2, 0)).stable for c in disc]
    assert any(held)
    assert not all(held)
    path = tmp_path / "candidates.json"
    disc.save(path)
    words = ["resisted", "paper-three-contacts-preload-1", "--wrench", "0", "2", "0"]
    rows = run.json(*words, "--candidates", path)["candidates"]
    assert [row["verdict"] == "resisted" for row in rows] == held


def test_margin_of_chosen_contacts_on_the_command_line(run, refused):
    words = ["resisted", "paper-three-contacts", "--wrench", "0", "1", "0"]
    more = ["--margin", "--contacts", "1", "3", "--also", "0", "3", "0"]
    assert "resisted with a preload of contacts 1, 3 in [3, oo)" in run(*words, *more, code=1)
    refused(*words, "--contacts", "1")
    refused(*words, "--margin", "--also", "0", "3", "0")
