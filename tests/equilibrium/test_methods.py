"""The other methods on the paper's two grasps: what the paper says of each, and known values."""

import importlib
from fractions import Fraction
from itertools import pairwise
from pkgutil import iter_modules

import numpy as np
import pytest
from hypothesis import example, given, strategies as st
from scipy.spatial import ConvexHull

from arrangement.errors import OutOfReachError
from arrangement.numbers.exact import RationalVector, dot
from equilibrium import Contact, Grasp, ResistedSet, methods, read_grasp, solve
from equilibrium.core.contact_rows import friction_edges
from equilibrium.grasps.inputs.random import random_grasp
from equilibrium.methods.compare import compare, predict
from equilibrium.methods.cones import cones
from equilibrium.methods.form_closure import form_closure
from equilibrium.methods.grasp_robustness import contact_robustness, grasp_robustness
from equilibrium.methods.grasp_wrench_space import GraspWrenchSpace
from equilibrium.methods.method import Method
from equilibrium.methods.registry import (
    DECIDING,
    DECIDING_IN_SPACE,
    METHODS,
    WITH_REGION,
    method_named,
)
from equilibrium.methods.round_cones import round_cones
from equilibrium.methods.springs import (
    balancing_friction,
    frictionless_slip,
    linear_compliance,
    springs_of,
)
from equilibrium.methods.weak_strong import weak_strong
from equilibrium.model.errors import GraspError
from equilibrium.pictures.forces import draw_methods
from equilibrium.wrench_sets import Region
from equilibrium.wrench_sets.line import margin

from .strategies import grasps

HALF = Fraction(1, 2)
THREE, FOUR = read_grasp("paper-three-contacts"), read_grasp("paper-four-contacts")
LOADED = THREE.with_preload(1)
#: On the edge of the cones, as the paper says.
REST = (-HALF, 0, HALF)


def wrench_space(grasp, wrench):
    return GraspWrenchSpace(grasp).verdict(wrench)


@pytest.mark.parametrize(
    ("method", "grasp", "wrenches", "options", "accepts"),
    [
        # Section VI: contact forces exist for all forces in the plane, preload or not.
        (wrench_space, THREE, [(0, 1, 0), (1, 1, 0), (-3, 7, 0), (0, -5, 0)], {}, True),
        (wrench_space, Grasp(), [(0, 0, 0)], {}, True),
        (wrench_space, Grasp(), [(0, 0, 1)], {}, False),
        # Section III: the pushed object drags the side contacts out of their cones.
        *(
            (linear_compliance, THREE, [(0, -1, 0)], {"springs": springs_of(THREE, k)}, False)
            for k in ("1/1000", 1, 1000)
        ),
        # Section VI: better than linear compliance, and still too conservative.
        (frictionless_slip, THREE, [(0, -1, 0), (0, -100, 0), (3, -1, 0), (-7, 0, 0)], {}, True),
        # Without friction at rest soft tangential springs hold.
        (frictionless_slip, LOADED, [(0, 1, 0)], {}, False),
        (frictionless_slip, LOADED, [(0, 1, 0)], {"springs": springs_of(LOADED, HALF)}, True),
        # Section III: without dissipation an arbitrary wrench is resisted, with friction above 1.
        *(
            (cones, FOUR.with_friction(mu), [(0, 2, 0), (0, -200, 0), (5, 3, -1)], {}, True)
            for mu in (2, "101/100")
        ),
        # Springs that cannot let go refuse all loads.
        (cones, FOUR.with_friction(2), [(0, 2, 0)], {"printed": True}, False),
        (cones, FOUR, [(0, 0, 3)], {}, True),
        (cones, FOUR, [(0, 0, 3)], {"printed": True}, False),
    ],
)
def test_known_verdicts(method, grasp, wrenches, options, accepts):
    for wrench in wrenches:
        assert method(grasp, wrench, **options).accepts is accepts


def square(friction=0):
    """Eight frictionless fingers, two on each side of a square: form closure."""
    places = [((side, s * HALF), (-side, 0)) for side in (1, -1) for s in (1, -1)]
    places += [((s * HALF, side), (0, -side)) for side in (1, -1) for s in (1, -1)]
    return Grasp(Contact(point, normal, friction) for point, normal in places)


class TestGraspWrenchSpace:
    def test_slice_of_the_figure(self):
        # Upwards the side contacts give 1/2 with total normal force 1; downwards contact 2 gives 1.
        corners = GraspWrenchSpace(THREE).slice()
        assert max(v for _, v in corners) == HALF
        assert min(v for _, v in corners) == -1
        assert {u for u, v in corners if v == 0} == {-1, 1}

    def test_least_force_up_is_two_and_down_is_one(self):
        space = GraspWrenchSpace(THREE)
        assert space.verdict((0, 1, 0)).least_force == 2
        assert space.verdict((0, -1, 0)).least_force == 1
        assert GraspWrenchSpace(THREE, "Linf").verdict((0, 1, 0)).least_force == 1

    def test_volume_of_a_double_pyramid(self):
        # Cone edges of contacts at (+-1, 0), friction 1: (1, 1, -1), (1, -1, 1) and (-1, -1, -1),
        # (-1, 1, 1), a regular tetrahedron of edge 2 sqrt 2: volume 8/3, inscribed radius 1/sqrt 3.
        squeeze = read_grasp("opposed-contacts")
        space = GraspWrenchSpace(squeeze)
        assert space.volume == Fraction(8, 3)
        assert space.epsilon_squared == Fraction(1, 3)
        assert GraspWrenchSpace(squeeze, length=2).volume == Fraction(4, 3)

    @pytest.mark.parametrize("options", [{"norm": "L2"}, {"length": 0}, {"length": 0.5}])
    def test_bad_options_are_refused(self, options):
        with pytest.raises(ValueError, match=r"norm|length"):
            GraspWrenchSpace(THREE, **options)

    def test_hull_of_many_edges_in_space_is_refused(self):
        box = read_grasp("box-on-a-table")
        with pytest.raises(OutOfReachError, match="takes too long"):
            _ = GraspWrenchSpace(box, pyramid=6).epsilon_squared

    def test_a_slice_needs_a_plane(self):
        with pytest.raises(GraspError, match="parallel"):
            GraspWrenchSpace(THREE).slice(first=(1, 0, 0), second=(2, 0, 0))


def test_form_closure():
    for grasp in (THREE, FOUR):
        assert form_closure(grasp).accepts is None
        assert form_closure(grasp, friction=True).accepts
    assert form_closure(square()).accepts
    # Markenscoff, Ni, Papadimitriou 1990: four are needed.
    assert form_closure(Grasp(square().contacts[:3])).accepts is None


def test_linear_compliance_tells_motion_and_what_leaves_its_cone():
    verdict = linear_compliance(THREE, (0, -1, 0))
    # Springs of stiffness 1 in parallel, two tangential and one normal: a third each.
    assert (verdict.outside, verdict.motion) == ((0, 2), (0, Fraction(-1, 3), 0))
    assert balancing_friction(LOADED) == REST
    verdict = linear_compliance(LOADED, (0, 0, 0), springs_of(LOADED, 1, REST))
    assert verdict.motion == (0, 0, 0)
    assert verdict.forces == ((1, -HALF), (1, 0), (1, HALF))
    # One contact cannot balance a torque.
    verdict = linear_compliance(Grasp([Contact((0, 0), (0, 1), 1)]), (0, 0, 1))
    assert (verdict.accepts, verdict.motion) == (False, None)


@pytest.mark.parametrize("name", ["weak", "frictionless", "linear-compliance"])
def test_region_of_a_method_is_one_of_forces_alone(name):
    spans = ((1, 0, 0), (0, 1, 0))
    assert METHODS[name].region(THREE) == METHODS[name].region(THREE, spans, (0, 0, 0))


def test_linear_compliance_without_friction_refuses_pull():
    jaws = Grasp([Contact((-1, 0), (1, 0), 0), Contact((1, 0), (-1, 0), 0)])
    verdict = linear_compliance(jaws, (Fraction(1, 2), 0, 0))
    assert (verdict.accepts, verdict.outside) == (False, (0,))
    assert verdict.forces == ((-Fraction(1, 4), 0), (Fraction(1, 4), 0))
    assert linear_compliance(jaws, (0, 0, 0)).accepts


def test_frictionless_slip_tries_all_states():
    assert frictionless_slip(THREE, (0, -2, 0)).forces == ((0, 0), (2, 0), (0, 0))
    for factor in ("1/100", 1, 100):
        verdict = frictionless_slip(LOADED, (0, 1, 0), springs_of(LOADED, factor, REST))
        assert (verdict.accepts, verdict.tried) == (False, 27)
    with pytest.raises(OutOfReachError, match="13 contacts with a choice of three states"):
        frictionless_slip(Grasp([Contact((0, 0), (1, 0), 1)] * 13), (0, 0, 0))


class TestWeakStrong:
    def test_without_springs_every_load_is_balanced(self):
        for wrench in ((0, 2, 0), (0, -200, 0), (5, 3, -1)):
            assert weak_strong(FOUR, wrench).weak

    def test_three_contacts(self):
        up, down = weak_strong(THREE, (0, 1, 0)), weak_strong(THREE, (0, -1, 0))
        assert (up.weak, up.strong, up.frictionless) == (True, False, False)
        assert (down.weak, down.strong, down.frictionless) == (True, True, True)
        assert up.acceleration == (0, 1, 0)  # nothing presses, so nothing brakes

    def test_block_on_a_slope_is_strong_but_not_frictionless(self):
        # Slope 3/4: friction 1 holds the block however it starts; friction 1/2 does not.
        feet = [(Fraction(x) * 4 / 5, Fraction(x) * 3 / 5) for x in (-1, 1)]
        normal = (Fraction(-3, 5), Fraction(4, 5))
        gravity = (0, -1, 0)
        rough, smooth = (Grasp(Contact(p, normal, mu) for p in feet) for mu in (1, HALF))
        held, sliding = weak_strong(rough, gravity), weak_strong(smooth, gravity)
        assert (held.weak, held.strong, held.frictionless) == (True, True, False)
        assert not sliding.weak

    def test_mass_must_be_positive(self):
        with pytest.raises(GraspError, match="mass"):
            weak_strong(THREE, (0, 1, 0), mass=0)


def test_an_answer_that_is_neither_yes_nor_no_has_no_truth_value():
    grasp = read_grasp("paper-three-contacts")
    found = compare(grasp, (0, 1, 0))
    assert not found
    assert not found["complete"]
    assert found["weak"]
    with pytest.raises(GraspError, match="neither yes nor no"):
        bool(found["form-closure"])
    with pytest.raises(GraspError, match="weak"):
        bool(weak_strong(grasp, (0, 1, 0)))


@pytest.mark.parametrize(
    ("name", "preload", "wrench", "stable", "disagreeing"),
    [
        # Without preload nothing holds an upward force; cones and closure methods say otherwise.
        ("paper-three-contacts", 0, (0, 1, 0), False, {"wrench-space", "weak"}),
        ("paper-three-contacts", 0, (0, -1, 0), True, {"linear-compliance"}),
        (
            "paper-three-contacts",
            1,
            (0, 1, 0),
            True,
            {"printed", "strong", "frictionless", "linear-compliance", "frictionless-slip"},
        ),
        ("paper-three-contacts", 1, (0, "11/10", 0), False, {"wrench-space", "weak"}),
        ("paper-four-contacts", 0, (0, 2, 0), False, {"wrench-space", "weak"}),
    ],
)
def test_rows_of_the_papers_tables(name, preload, wrench, stable, disagreeing):
    found = compare(read_grasp(name).with_preload(preload), wrench)
    assert found.stable is stable
    assert set(found.disagreeing) - {"printed"} == disagreeing - {"printed"}
    assert found["form-closure"].accepts is None
    assert [answer.method for answer in found.answers] == list(DECIDING)


@pytest.mark.parametrize(("wrench", "yes"), [((0, -1, 0), True), ((0, 1, 0), False)])
def test_a_result_is_true_exactly_when_it_says_yes(wrench, yes):
    grasp = read_grasp("paper-three-contacts")
    compared = compare(grasp, wrench)
    for found in (
        solve(grasp, wrench),
        solve(grasp, wrench, as_printed=["single-solution"]),
        margin(grasp, wrench),
        frictionless_slip(grasp, wrench),
        compared,
        compared["complete"],
    ):
        assert bool(found) is yes
    for answer in compared.answers:
        if answer.accepts is not None:
            assert bool(answer) is answer.accepts
    assert compared["form-closure"].accepts is None


def test_every_file_of_a_method_is_in_the_table():
    files = (f"{methods.__name__}.{file.name}" for file in iter_modules(methods.__path__))
    values = [value for file in files for value in vars(importlib.import_module(file)).values()]
    written = {id(value) for value in values if isinstance(value, Method)}
    # Two methods with one key would leave one of them out.
    assert {id(method) for method in METHODS.values()} == written


class TestCommands:
    def test_compare(self, run):
        arguments = ["solve", "paper-three-contacts", "--wrench", "0", "-1", "0", "--methods"]
        document = run.json(*arguments)
        agreeing = {row["method"]: row["agrees"] for row in document["methods"]}
        assert agreeing.pop("linear-compliance") is False
        assert agreeing.pop("form-closure") is None
        assert agreeing.pop("printed") in (True, False)
        assert agreeing.pop("pcr") is agreeing.pop("pgr") is None
        assert set(agreeing.values()) == {True}
        lines = run(*arguments).splitlines()
        assert [line for line in lines if line.startswith("!") and "linear compliance" in line]
        assert lines[-2:] == [
            "-  the method has no verdict on this wrench",
            "!  another verdict than that of the full model",
        ]

    def test_compare_rounds_numbers_as_solve_does(self, run):
        load = "1/12345678912345"
        words = ["solve", "opposed-contacts", "--wrench", "0", load, "0", "--methods"]
        assert "total normal force at least ≈8.1e-14" in run(*words, code=None)
        assert f"total normal force at least {load}" in run(*words, "--exact", code=None)

    def test_wrench_space(self, run):
        document = run.json("info paper-three-contacts --force-closure")
        assert document["force_closure"] is True
        # One row of four integers or rationals for each of the eight triangles of an octahedron.
        assert [len(row) for row in document["facets"]] == [4] * 8
        assert ["0", "1/2"] in document["slice"]["corners"]
        assert "volume" in run("info paper-three-contacts --force-closure --norm Linf")


LOADS = [(0, 1, 0), (1, 1, 0), (-3, 7, 1), (0, -5, 2)]


def on_a_table(x, y, z):
    return (x, y, z, 0, 0, 0)


@pytest.mark.parametrize("name", ["three-fingers-on-a-ball", "box-held-by-four"])
def test_the_exact_hull_has_the_radius_of_scipys(name):
    grasp = read_grasp(name)
    edges = [edge for contact in grasp for edge in friction_edges(contact)]
    hull = ConvexHull(np.array([[0] * 6, *edges], dtype=float))
    assert GraspWrenchSpace(grasp).epsilon == pytest.approx(min(-hull.equations[:, -1]))


def test_torques_over_a_length_change_the_radius_alone():
    grasp = read_grasp("box-held-by-four")
    one, other = GraspWrenchSpace(grasp), GraspWrenchSpace(grasp, length=Fraction(1, 10))
    assert one.force_closure
    assert other.force_closure
    assert one.epsilon_squared != other.epsilon_squared


@pytest.mark.parametrize("name", ["paper-three-contacts", "paper-four-contacts"])
@pytest.mark.parametrize("wrench", LOADS)
def test_planar_grasps_answer_as_in_the_plane(name, wrench):
    grasp, (x, y, torque) = read_grasp(name), wrench
    flat, solid = compare(grasp, wrench), compare(grasp.in_space(), (x, y, 0, 0, 0, torque))
    assert tuple(answer.method for answer in solid.answers) == DECIDING_IN_SPACE
    for key in ("complete", "wrench-space", "weak", "frictionless"):
        assert solid[key].accepts is flat[key].accepts


def test_a_round_cone_holds_what_its_pyramid_lets_go():
    table = read_grasp("box-on-a-table")
    assert len({contact.friction for contact in table}) == 1
    push = table.contacts[0].friction * Fraction(7, 10)
    load = on_a_table(push, push, -1)
    for method in ("weak", "wrench-space"):
        assert compare(table, load)[method].accepts is True
        assert compare(table, load, pyramid=4)[method].accepts is False
    beyond = table.contacts[0].friction * Fraction(71, 100)
    assert compare(table, on_a_table(beyond, beyond, -1))["weak"].accepts is False


@pytest.mark.parametrize("seed", range(8))
def test_both_answers_of_round_cones_are_proofs(seed):
    grasp = random_grasp(4, seed=seed, dimension=3)
    load = tuple(map(Fraction, (1, -2, 1, 0, 1, 1)))
    found = round_cones(grasp, load)
    assert found.accepts is not None
    if found.accepts:
        total = list(load)
        for contact, force in zip(grasp, found.forces, strict=True):
            normal, *friction = force
            assert normal >= 0
            assert sum(x * x for x in friction) <= (contact.friction * normal) ** 2
            rows = (contact.normal_wrench, *contact.tangential_wrenches)
            for factor, row in zip(force, rows, strict=True):
                total = [a + factor * b for a, b in zip(total, row, strict=True)]
        assert not any(total)
    else:
        motion = found.separating_motion
        assert dot(load, motion) > 0
        for contact in grasp:
            push = dot(contact.normal_wrench, motion)
            slip = sum(dot(row, motion) ** 2 for row in contact.tangential_wrenches)
            assert push >= 0
            assert push**2 >= contact.friction**2 * slip


def test_form_closure_in_space_takes_seven_contacts():
    """Twelve fingers off the middles of the sides of a box stop every turn; six of them do not."""
    contacts = []
    for axis in range(3):
        for side in (1, -1):
            for shift in (1, -1):
                point, normal = [Fraction(0)] * 3, [0] * 3
                point[axis], normal[axis] = Fraction(side), -side
                point[(axis + 1) % 3] = Fraction(shift, 2)
                contacts.append(Contact(point, normal, 0))
    closed = form_closure(Grasp(contacts))
    assert closed.accepts is True
    for row in zip(*(c.normal_wrench for c in contacts), strict=True):
        assert dot(row, closed.multipliers) == 0
    free = form_closure(Grasp(contacts[:6]))
    assert free.accepts is None
    assert all(dot(c.normal_wrench, free.free_motion) >= 0 for c in contacts[:6])


def test_the_command_takes_a_grasp_in_space(run):
    load = ["--wrench", "0", "0", "0", "1", "0", "0"]
    found = run.json("solve two-opposed-fingers", *load, "--methods", code=1)
    assert found["stable"] is False
    assert [entry["method"] for entry in found["methods"]] == list(DECIDING_IN_SPACE)


def test_pyramids_are_for_all_methods_with_friction(run):
    between = ["--wrench", "0", "7/10", "7/10", "0", "0", "0"]
    run("solve two-opposed-fingers", *between, "--methods")
    pyramids = ["--cone", "pyramid:4"]
    found = run.json("solve two-opposed-fingers", *between, "--methods", *pyramids, code=1)
    assert (found["pyramid"], found["stable"]) == (4, False)
    fingers, load = read_grasp("two-opposed-fingers"), (0, "7/10", "7/10", 0, 0, 0)
    assert compare(fingers, load, pyramid=16).stable
    assert compare(fingers, load, pyramid=16)["weak"].accepts


def test_the_wrench_space_in_space_has_a_radius_and_no_slice(run):
    found = run.json("info box-held-by-four --force-closure")
    assert (found["epsilon_squared"], found["pyramid"]) == ("4/25", 4)
    assert not {"volume", "slice"} & set(found)


def test_the_table_of_methods_is_drawn_in_space_too():
    questions = [(0, 1, 0, 0, 0, 0), (0, 0, 0, 1, 0, 0)]
    scene = draw_methods.scene(read_grasp("two-opposed-fingers"), wrenches=questions)
    cells = {item.name for item in scene.items if item.name.startswith("cell")}
    assert len(cells) == 2 * len(DECIDING_IN_SPACE)


STEP = Fraction(1, 7)


def accepts(method: str, grasp: Grasp, wrench: tuple[Fraction, ...]) -> bool | None:
    """The verdict on one wrench, by the linear programs of the methods."""
    if not method.startswith("wrench-space"):
        return predict(method, grasp, wrench)
    norm = "L1" if method.endswith("L1") else "Linf"
    least = GraspWrenchSpace(grasp, norm).verdict(wrench).least_force
    return least is not None and least <= 1


def probes(region: Region) -> list[RationalVector]:
    """Points of the plane near which the answer changes: corners, middles, and close by."""
    corners = [p for piece in region.polygons for p in piece.polyhedron.points][:5]
    corners += [(Fraction(0), Fraction(0))]
    middles = [tuple((x + y) / 2 for x, y in zip(p, q, strict=True)) for p, q in pairwise(corners)]
    steps = [(0, 0), (STEP, 0), (-STEP, STEP), (0, -STEP)]
    near = [(p[0] + a, p[1] + b) for p in corners for a, b in steps]
    return [*near, *middles]


@pytest.mark.slow
@pytest.mark.parametrize("method", WITH_REGION)
@given(grasp=grasps(), torque=st.sampled_from([0, 0, HALF, -1]))
@example(grasp=read_grasp("paper-three-contacts-preload-1"), torque=0)
@example(grasp=read_grasp("offset-three-contacts").with_preload(1), torque=1)
@example(
    grasp=Grasp(
        [
            Contact((0, 0), (1, 0), 1, 1, 1),
            Contact((0, 0), (-1, 0), 0),
            Contact((1, 0), (0, 1), HALF, 1, 2),
        ]
    ),
    torque=0,
)
def test_region_and_single_verdicts_agree(method, grasp, torque):
    region = METHODS[method].region(grasp, origin=(0, 0, torque))
    for x, y in probes(region):
        load = (x, y, Fraction(torque))
        assert region.contains((x, y)) is accepts(method, grasp, load), load


@pytest.mark.parametrize("norm", ["L1", "Linf"])
def test_wrench_space_region_has_the_corners_of_its_slice(norm):
    grasp = read_grasp("paper-three-contacts")
    (piece,) = METHODS[f"wrench-space-{norm}"].region(grasp).polygons
    corners = GraspWrenchSpace(grasp, "L1" if norm == "L1" else "Linf").slice()
    assert set(piece.polyhedron.points) == set(corners)


def test_unknown_methods_and_too_many_contacts_are_refused():
    with pytest.raises(GraspError, match="expected one of complete"):
        method_named("guess")
    nine = Grasp([Contact((0, 0), (1, 0), 0)] * 9)
    assert METHODS["frictionless-slip"].outcome(nine, (0, 0, 0))[1].startswith("not tried: three")
    with pytest.raises(OutOfReachError, match="states of each of 9 contacts"):
        METHODS["frictionless-slip"].region(nine)
    with pytest.raises(GraspError, match="no region"):
        METHODS["strong"].region(Grasp())


def test_robustness_of_the_four_contacts_by_hand():
    """R^T R = diag(1/4, 1/4, 1/8), and each cone of slope 1/2 is 1/sqrt(5) away from its axis."""
    grasp = read_grasp("paper-four-contacts-preload-1")
    for bound in (contact_robustness(grasp), grasp_robustness(grasp)):
        assert bound.squared_distance == Fraction(1, 5)
        assert bound.gain == tuple(
            tuple(Fraction(int(i == j), (4, 4, 8)[i]) for j in range(3)) for i in range(3)
        )
        assert bound.value == pytest.approx(2 / 5**0.5)
        assert bound.covers((0, Fraction(894427, 10**6), 0))
        assert not bound.covers((0, Fraction(894428, 10**6), 0))
    found = compare(grasp, (0, "1/2", 0), methods=["pcr", "pgr"])
    assert [answer.accepts for answer in found.answers] == [True] * 3
    beyond = compare(grasp, (0, 1, 0), methods=["pcr", "pgr"])
    assert [answer.accepts for answer in beyond.answers] == [True, None, None]


def test_slip_raises_the_robustness_of_slippery_jaws():
    """With little friction a cone is left sooner than a contact: better to let all but one slip."""
    grasp = read_grasp("paper-four-contacts-preload-1").with_friction("1/100")
    low, high = contact_robustness(grasp).value, grasp_robustness(grasp)
    assert high.value >= low > 0
    assert grasp_robustness(read_grasp("paper-three-contacts-preload-1")).value == 0
    unbalanced = Grasp([Contact((0, 0), (1, 0), 1, preload=1)])
    assert contact_robustness(unbalanced) is None
    assert METHODS["pgr"].outcome(unbalanced, (0, 0, 0))[0] is None


@pytest.mark.parametrize("name", ["paper-four-contacts-preload-1", "all-contacts-stick"])
def test_no_smaller_wrench_than_the_robustness_is_unresisted(name):
    grasp = read_grasp(name)
    size = ResistedSet(grasp).smallest_outside().size_squared
    bound = grasp_robustness(grasp)
    assert bound is not None
    assert size is None or bound.value**2 <= float(size) + 1e-9
