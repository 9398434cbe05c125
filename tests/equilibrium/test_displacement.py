"""Only equilibria count that move contact points by no more than a largest displacement."""

import json
import subprocess
from dataclasses import replace
from fractions import Fraction
from random import Random

import pytest

from arrangement.drawing.pages import _text
from arrangement.errors import InputError
from equilibrium import Contact, Grasp, read_grasp, solve
from equilibrium.certificate.checker import check
from equilibrium.certificate.leaves import parts
from equilibrium.certificate.report import Report
from equilibrium.decide import engines as deciding, verdict as verdicts
from equilibrium.decide.solver import Solver
from equilibrium.grasps.inputs.csv_file import parse_csv
from equilibrium.grasps.inputs.random import random_grasp, random_wrench
from equilibrium.model.displacement import (
    STIFFNESS_ASSUMED,
    displacement,
    has_unit,
    small_displacement,
    spread,
    warning,
)
from equilibrium.model.errors import EquilibriumError
from equilibrium.model.solution import Leaf
from equilibrium.pictures.lab.page import DECIDES
from equilibrium.plane.search.units import unit_of
from equilibrium.wrench_sets import ResistedSet
from equilibrium.wrench_sets.along_in_space import spatial_magnitudes
from equilibrium.wrench_sets.line import margin, resisted_magnitudes, sufficient_preloads
from equilibrium.wrench_sets.polyhedra import states_with

from . import oracle
from .degenerate import question

THREE = "paper-three-contacts-preload-1"
#: An equilibrium under it turns by 1 at least.
TURNED = (0, Fraction(1, 2), Fraction(1, 2))
#: A wedge of 4 cm, too steep to hold itself, between two fingers.
WEDGE = "x,y,nx,ny,mu,preload\n0,0.02,0.6,-0.8,0.5,100\n0,-0.02,0.6,0.8,0.5,100\n"
OUT = (-1, 0, 0)


def test_one_stiffness_or_preload_gives_displacements_a_unit():
    bare, given = Contact([0, 0], [0, 1], 0), Contact([1, 0], [0, 1], 0, 1)
    loaded = Contact([2, 0], [0, 1], 0, preload=1)
    assert has_unit(Grasp([bare, given]))
    assert has_unit(Grasp([bare, loaded]))
    assert not has_unit(Grasp([bare, bare]))
    pairs = [bare, given], [given, given], [bare, replace(bare, point=(1, 0))]
    measured = [Grasp(pair).with_units("m", "N") for pair in pairs]
    assert list(map(small_displacement, measured)) == [Fraction(1, 10), None, None]
    assert small_displacement(Grasp(pairs[0])) is None
    assert spread([]) == 0


def bounded_questions(count: int):
    """Yield degenerate problems of two and three contacts with bounds at, below and above."""
    seeds = (seed for seed in range(2 * count) if seed % 4 < 2)
    for seed in seeds:
        asked, source = question(seed), Random(seed)
        free = next(oracle.solutions(asked.grasp, asked.wrench), None)
        bounds = [Fraction(0), Fraction(source.randint(1, 64), 32)]
        if free is not None:
            size, near = displacement(asked.grasp, free.motion), Fraction(1, 1000)
            share = Fraction(source.randint(1, 8), 8)
            bounds = [size, size * (1 - near), size * (1 + near), Fraction(0), size * share]
        yield asked, source.choice(bounds)


@pytest.mark.parametrize("count", [10, pytest.param(100, marks=pytest.mark.slow)])
def test_bounded_verdicts_agree_with_brute_force(count):
    answers = []
    for asked, bound in bounded_questions(count):
        verdict = solve(asked.grasp, asked.wrench, max_displacement=bound)
        wanted = oracle.is_stable(asked.grasp, asked.wrench, displacement=bound)
        assert verdict.stable == wanted, (asked.seed, bound)
        assert verdict.verify(), (asked.seed, bound)
        answers.append(wanted)
    assert len(answers) == count
    assert min(answers.count(True), answers.count(False)) > count / 5


@pytest.mark.parametrize("stiffness", [None, 10000])
@pytest.mark.parametrize("wrench", [OUT, (0, 0, 0)])
@pytest.mark.parametrize("dimension", [2, 3])
def test_object_that_leaves_the_hand_has_a_warning(stiffness, wrench, dimension):
    grasp = parse_csv(WEDGE).grasp
    if stiffness:
        grasp = Grasp(replace(c, stiffness=Fraction(stiffness)) for c in grasp)
    if dimension == 3:
        grasp, wrench = grasp.in_space(), (*wrench[:2], 0, 0, 0, wrench[2])
    assert solve(grasp, wrench).warnings == ()
    grasp = grasp.with_units("m", "N")
    found = solve(grasp, wrench)
    assert found.stable
    assert found.warnings == (warning(every=True),)
    refused = solve(grasp, wrench, max_displacement=small_displacement(grasp))
    assert refused.verdict == "not resisted"
    assert refused.verify()


def test_wedge_is_not_resisted_with_a_bound(tmp_path, run):
    path, proof = tmp_path / "wedge.json", tmp_path / "proof.json"
    path.write_text(json.dumps(parse_csv(WEDGE).grasp.with_units("m", "N").to_dict()))
    arguments = ["solve", str(path), "--wrench", "-1", "0", "0"]
    assert warning(every=True) in run(*arguments)
    bounded = [*arguments, "--max-displacement", "1/100", "--certificate", str(proof)]
    assert "not resisted, among displacements of contacts up to 1/100" in run(*bounded, code=1)
    question = ["--grasp", str(path), "--wrench", "-1", "0", "0"]
    run("verify", proof, *question, "--max-displacement", "1/100")
    run("verify", proof, *question, code=1)
    run(*arguments, "--max-displacement", "325/2")


def test_displacements_without_stiffness_have_no_unit(run, tmp_path):
    text = WEDGE.replace(",preload", "").replace(",100\n", "\n")
    for given, said in ((text, True), (text.replace("mu", "mu,k").replace("0.5", "0.5,1"), False)):
        path = tmp_path / "wedge.csv"
        path.write_text(given)
        for bound in ("", "--max-displacement 1"):
            out = run(f"solve {{}} --wrench -1 0 0 {bound}", path, code=None)
            assert (STIFFNESS_ASSUMED in out) == said
    fingers = [Contact((-1, 0), (1, 0), 1), Contact((1, 0), (-1, 0), 1)]
    pinch = Grasp([Contact((0, 0), (0, 1), 1), *fingers]).with_units("m", "N")
    found = solve(pinch, (0, -10, 0))
    assert displacement(pinch, found.solution.motion) > 1
    assert found.warnings == ()
    known = Grasp((replace(c, stiffness_given=True) for c in pinch), pinch.units)
    assert solve(known, (0, -10, 0)).warnings
    assert known == pinch
    assert not any(c.stiffness_given for c in pinch.with_preload(0).in_space())


def test_checker_must_accept_a_proof_before_the_verdict_leaves(monkeypatch, run):
    grasp = read_grasp(THREE)
    with monkeypatch.context() as forging:
        forging.setattr(verdicts, "proof_report", lambda *_: Report("resisted", "forged"))
        with pytest.raises(EquilibriumError, match="internal error") as caught:
            solve(grasp, (0, 1, 0))
    assert not isinstance(caught.value, InputError)
    assert not solve(grasp, (0, 2, 0)).stable
    monkeypatch.setattr(deciding, "resistance", lambda *_: Leaf((1, 0, 0), {}))
    for wrench in ((0, 2, 0), (0, 1, 0)):
        with pytest.raises(EquilibriumError, match="internal error"):
            solve(grasp, wrench)
    assert run("solve {} --wrench 0 2 0", THREE, code=70) == ""


@pytest.mark.parametrize(("contacts", "seed"), [(2, 4), (3, 6)])
def test_a_bounded_verdict_is_that_of_all_equilibria(contacts, seed):
    grasp, wrench = random_grasp(contacts, seed), random_wrench(seed)
    found = solve(grasp, wrench).equilibria
    sizes = [displacement(grasp, piece.motion) for piece in found]
    for bound in (size * Fraction(k, 1000) for size in sizes for k in (999, 1000, 1001)):
        solver = Solver(grasp, bound)
        verdict = solver.solve(wrench)
        wanted = any(size <= bound for size in sizes)
        assert wanted <= verdict.stable
        if all(piece.unique for piece in found):
            assert verdict.stable == wanted
        assert bool(solver.choices.equilibria(verdict.wrench)) == verdict.stable
        assert verdict.verify()
        assert verdict.verify().max_displacement == bound


@pytest.mark.parametrize("bound", ["1/10", "999/1000", "2"])
def test_a_bounded_proof_proves_nothing_without_the_bound(bound):
    grasp = read_grasp(THREE)
    verdict = solve(grasp, TURNED, max_displacement=bound)
    assert verdict.stable == (bound == "2")
    document = verdict.certificate.to_dict()
    assert document["max_displacement"] == bound
    asked = grasp, verdict.wrench
    assert check(document, asked, max_displacement=Fraction(bound))
    assert not check(document, asked)
    assert not check(document, asked, max_displacement=Fraction(1, 2))
    changed = {**document, "max_displacement": "2" if not verdict.stable else "99/100"}
    assert not check(changed)
    del changed["max_displacement"]
    assert bool(check(changed)) == verdict.stable


def test_forged_displacements_of_a_leaf_are_refused():
    asked = solve(read_grasp(THREE), TURNED, max_displacement="1/10").certificate.to_dict()
    leaf = {"virtual_motion": [0, 0, 0], "multipliers": {}, "displacements": {"1": [1, -2]}}
    # The bound itself costs: the part of the motions inside stays open.
    assert "above 0" in check({**asked, "tree": leaf}).problem
    unbounded = {key: x for key, x in asked.items() if key != "max_displacement"}
    assert "no largest displacement" in check({**unbounded, "tree": leaf}).problem
    for wrong in ({"1": [1]}, {"1": [1, 2, 3]}, {"3": [1, 2]}, [1, 2]):
        with pytest.raises(InputError):
            check({**asked, "tree": {**leaf, "displacements": wrong}})


@pytest.mark.parametrize("name", ["largest_turn", "largest_force"])
def test_older_bounds_in_a_certificate_are_refused(name):
    document = solve(read_grasp(THREE), TURNED).certificate.to_dict()
    with pytest.raises(InputError, match=f"has {name}; expected max_displacement"):
        check({**document, name: "1"})


def test_regions_across_a_bound_are_closed_with_its_multiplier():
    grasp, wrench = random_grasp(20, 0), random_wrench(0)
    most = displacement(grasp, solve(grasp, wrench).solution.motion)
    verdict = solve(grasp, wrench, max_displacement=Fraction(round(970 * most), 1000))
    assert verdict.verdict == "not resisted"
    leaves = [part.leaf for part in parts(verdict.certificate.to_dict())]
    across = [leaf for leaf in leaves if any(leaf.motion) and leaf.displacements]
    assert len(across) > len(leaves) / 8
    assert verdict.verify().leaves == len(leaves) < 400


@pytest.mark.parametrize("bound", ["1e-5000", "1e5000"])
@pytest.mark.parametrize("size", ["1", "1e-5000", "1e5000"])
def test_bounds_beyond_floats_are_decided(bound, size):
    preload = Fraction(size)
    fingers = Grasp(Contact([-n, 0], [n, 0], "1/2", 1, preload) for n in (1, -1))
    for load in (preload, 2 * preload):
        verdict = solve(fingers, [0, -load, 0], max_displacement=bound)
        assert verdict.stable is (load == preload)
        assert verdict.verify()


def test_an_equilibrium_beyond_the_bound_is_refused():
    found = solve(read_grasp(THREE), TURNED)
    document, most = found.certificate.to_dict(), displacement(found.grasp, found.solution.motion)
    assert check({**document, "max_displacement": str(most)})
    less = check({**document, "max_displacement": str(most * Fraction(999, 1000))})
    assert "its point moves by" in less.problem


@pytest.mark.parametrize("value", [None, -1, "-1/2", 0.5, "x"])
def test_a_bound_is_an_exact_number_of_at_least_0(value):
    document = solve(read_grasp(THREE), TURNED).certificate.to_dict()
    with pytest.raises(InputError, match="max_displacement"):
        check({**document, "max_displacement": value})
    if value is not None:
        with pytest.raises(InputError, match="max_displacement"):
            solve(read_grasp(THREE), TURNED, max_displacement=value)


def test_wrench_sets_hold_what_bounded_verdicts_say():
    solver = Solver(read_grasp(THREE), "1/10")
    line = resisted_magnitudes(solver, TURNED)
    everything = ResistedSet(solver.grasp, max_displacement="1/10")
    assert line.intervals == everything.along(TURNED).intervals == margin(solver, TURNED).intervals
    ((low, high),) = line.intervals
    assert low == 0 < high < 1
    for t in (high, high * Fraction(1001, 1000), Fraction(1)):
        wrench = [t * w for w in TURNED]
        assert solver.solve(wrench).stable == line.contains(t) == (wrench in everything)
        assert bool(states_with(everything.polyhedra, wrench)) == line.contains(t)


def test_bounded_preloads_are_those_that_verdicts_accept():
    grasp, wrench = read_grasp("paper-four-contacts"), (0, 2, Fraction(1, 2))
    found = sufficient_preloads(Solver(grasp, "1/4"), wrench).intervals
    for p in (Fraction(k, 4) for k in range(25)):
        loaded = Solver(grasp.with_preload(p), "1/4")
        inside = any(low <= p and (high is None or p <= high) for low, high in found)
        assert loaded.solve(wrench).stable == inside
    assert found


@pytest.mark.parametrize("seed", [2, 6])
def test_a_verdict_in_space_keeps_the_bound(seed):
    grasp = random_grasp(4, seed, dimension=3).with_preload(1)
    wrench = random_wrench(seed, dimension=3, bound=1)
    free = solve(grasp, wrench)
    assert free.stable
    size = displacement(grasp, free.solution.motion).limit_denominator(1000)
    for scale in ("1/2", "2"):
        bound = Fraction(scale) * size
        found = solve(grasp, wrench, max_displacement=bound)
        assert found.decided
        assert found.verify()
        document = found.certificate.to_dict()
        other = bound / 1000 if found.stable else 4 * bound
        assert found.stable == (scale == "2")
        assert not check({**document, "max_displacement": str(other)})


def test_a_bound_in_space_bounds_magnitudes():
    grasp = read_grasp("two-opposed-fingers")
    along = (0, 1, 0, 0, 0, 0)
    free = spatial_magnitudes(grasp, along, width="1/100")
    none = spatial_magnitudes(grasp, along, width="1/100", max_displacement=0)
    assert free.borders
    assert none.borders


@pytest.mark.parametrize("seed", range(4))
def test_pyramids_have_a_bound_too(seed):
    grasp, wrench = random_grasp(3, seed, dimension=3), random_wrench(seed, dimension=3, bound=1)
    free = solve(grasp, wrench, pyramid=4)
    if not free.stable:
        assert solve(grasp, wrench, pyramid=4, max_displacement=9).verdict == free.verdict
        return
    size = displacement(grasp, free.solution.motion)
    assert solve(grasp, wrench, pyramid=4, max_displacement=size).stable
    none = solve(grasp, wrench, pyramid=4, max_displacement=size / 1000)
    assert none.verdict == "not resisted"
    assert none.verify()
    assert not check({**none.certificate.to_dict(), "max_displacement": str(10 * size)})


def test_oblique_planes_prove_nothing_with_a_bound():
    flat = parse_csv(WEDGE).grasp
    planar = solve(flat, (0,) * 3, max_displacement="1/1000").certificate.to_dict()
    tree = {"plane": [["1", "0", "0"], ["0", "1", "0"]], "tree": planar["tree"]}
    space = {"grasp": flat.in_space().to_dict(), "wrench": ["0"] * 6}
    document = {**planar, **space, "tree": tree}
    assert check(document)
    turned = [c["tangent"] for c in document["grasp"]["contacts"]]
    for contact, (x, y, _) in zip(document["grasp"]["contacts"], turned, strict=True):
        contact["tangent"] = [str(Fraction(3, 5) * Fraction(t)) for t in (x, y)] + ["4/5"]
    assert "at an angle to the plane" in check(document).problem
    del document["max_displacement"]
    assert "at an angle" not in check(document).problem


def test_spatial_equilibria_complete_only_if_proved():
    soft = random_grasp(4, 2, dimension=3).with_units("m", "N")
    wrench = random_wrench(2, dimension=3, bound=1)
    hard = Grasp((replace(c, stiffness=1000 * c.stiffness) for c in soft), soft.units)
    assert solve(hard, wrench).warnings == ()
    found = solve(soft, wrench)
    (line,) = found.warnings
    proved = solve(soft, wrench, max_displacement=small_displacement(soft))
    assert ("every equilibrium" in line) == (proved.verdict == "not resisted")


@pytest.fixture(scope="module")
def measured(tmp_path_factory):
    """The grasp with units, and its file."""
    grasp = read_grasp(THREE).with_units("m", "N")
    path = tmp_path_factory.mktemp("measured") / "grasp.json"
    path.write_text(json.dumps(grasp.to_dict()), encoding="utf-8")
    return grasp, str(path)


def test_without_units_no_motion_is_large(run, tmp_path):
    """The size of displacements means nothing there, and no verdict depends on it."""
    grasp = read_grasp(THREE)
    assert small_displacement(grasp) is None
    assert solve(grasp, TURNED).warnings == ()
    assert "beyond" not in run("solve {} --wrench 0 1/2 1/2", THREE)
    path = tmp_path / "grasp.svg"
    words = ["--wrench", "0", "1/2", "1/2", "-o", str(path), "--text", "text"]
    run("draw", THREE, *words)
    assert "beyond" not in path.read_text()


def test_only_large_motions_have_a_warning(run, measured):
    grasp, path = measured
    assert solve(grasp, (0, -1, 0)).warnings == ()
    assert solve(grasp, TURNED, max_displacement=3).warnings == ()
    (line,) = solve(grasp, TURNED).warnings
    assert line.startswith("beyond small motions: every equilibrium")
    arguments = ["solve", path, "--wrench", "0", "1/2", "1/2"]
    assert run(*arguments).splitlines()[-1] == line
    assert run.json(*arguments)["warnings"] == [line]
    printed = run(*arguments, "--max-displacement", "1/10", code=1)
    assert "among displacements of contacts up to 1/10" in printed


def test_one_contact_says_nothing_of_what_is_small():
    grasp = Grasp([Contact((0, 0), (0, 1), 0, 2, 1)]).with_units("m", "N")
    assert small_displacement(grasp) is None
    assert solve(grasp, (0, -100, 0)).warnings == ()


def test_a_picture_says_that_motions_are_not_small(tmp_path, measured, run):
    path = tmp_path / "grasp.svg"
    arguments = [
        "draw",
        measured[1],
        "--wrench",
        "0",
        "1/2",
        "1/2",
        "-o",
        str(path),
        "--text",
        "text",
    ]
    run(*arguments)
    assert "beyond small motions" in path.read_text()
    run(*arguments, "--max-displacement", "1/10")
    assert "no equilibrium, among displacements of contacts up to 1/10" in path.read_text()


def test_a_frictionless_disc_turns_too_far_to_resist_a_torque():
    """Normals that miss the centre by 10^-6 hold a torque by a turn without any meaning."""
    small = Fraction(1, 10**6)
    cosine, sine = (1 - small**2) / (1 + small**2), 2 * small / (1 + small**2)
    normals = [(cosine, sine), (-sine, cosine), (-cosine, sine), (sine, -cosine)]
    disc = Grasp(Contact((-x, -y), n, 0, 1, 1) for (x, y), n in
                 zip([(1, 0), (0, 1), (-1, 0), (0, -1)], normals, strict=True))  # fmt: skip
    disc = disc.with_units("m", "N")
    wrench = (0, 0, 10 * small)
    free = solve(disc, wrench)
    assert free.stable
    assert free.warnings
    refused = solve(disc, wrench, max_displacement="1/10")
    assert not refused.stable
    assert refused.verify()


def test_the_checker_of_the_page_refuses_a_bound():
    text = "\n".join(map(_text, DECIDES))
    document = solve(read_grasp(THREE), TURNED, max_displacement=3).certificate.text
    script = f"{text}\nlet said = ''; try {{ checkDocument({document}); }} catch (e) {{ said = e.message; }} console.log(said);"  # noqa: E501
    done = subprocess.run(["node", "-e", script], capture_output=True, text=True, check=False)
    if done.returncode:
        pytest.fail(done.stderr[-500:])
    assert "knows no bounded displacements" in done.stdout


@pytest.mark.parametrize(
    ("dimension", "length"),
    [(2, Fraction(3, 100)), (3, Fraction(1000))],
)
def test_units_change_no_verdict_and_no_size_of_the_proof(length, dimension):
    for seed in (0, 7):
        grasp = random_grasp(4, seed, dimension=dimension)
        wrench = random_wrench(seed, dimension=dimension, bound=1)
        points = [tuple(length * x for x in c.point) for c in grasp]
        moved = Grasp(
            Contact(p, c.normal, c.friction, 100 * c.stiffness, 10 * c.preload)
            for p, c in zip(points, grasp, strict=True)
        )
        load = [10 * w * (1 if j < dimension else length) for j, w in enumerate(wrench)]
        one, other = solve(grasp, wrench), solve(moved, load)
        assert one.stable == other.stable
        assert 0 <= one.verify().leaves == other.verify().leaves
        assert one.verify()
        assert other.verify()


def test_unit_is_largest_number_or_power_of_two():
    for number in (Fraction(1), Fraction(3, 100), Fraction(-7, 5), Fraction(10**9, 7)):
        assert unit_of([number, number / 3]) == abs(number)
        number += Fraction(1, 3**50)
        unit = unit_of([number, number / 3])
        assert 1 <= abs(number) / unit < 2
        assert (
            unit.numerator & (unit.numerator - 1) == 0 == unit.denominator & (unit.denominator - 1)
        )
    assert unit_of([]) == unit_of([Fraction(0)]) == 1


def test_no_displacement_takes_nothing_from_the_work():
    """Jaws that squeeze at rest: the two normals cancel, so a leaf of both has work 0."""
    grasp = Grasp(Contact((x, 0), (-x, 0), "1/2", 1, 1) for x in (-1, 1))
    held = solve(grasp, (0, 0, 0), max_displacement=0).certificate.to_dict()
    leaf = {"virtual_motion": ["0"] * 3, "multipliers": {}}
    leaf["displacements"] = {"0": ["1", "0"], "1": ["1", "0"]}
    kept = {key: held[key] for key in ("schema_version", "grasp", "wrench", "max_displacement")}
    found = check({**kept, "certificate": "not resisted", "tree": leaf})
    assert not found
    assert "is 0, and must be" in found.problem
