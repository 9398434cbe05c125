"""Smooth contacts typed in decimals: what the exact data do is never firmly denied."""

import json
from fractions import Fraction as F
from random import Random

import pytest

from equilibrium import Assembly, Contact, Grasp, ResistedSet, solve
from equilibrium.certificate.checker import check
from equilibrium.grasps.inputs.csv_file import parse_csv
from equilibrium.grasps.schemas import assembly_schema
from equilibrium.model.labels import AS_ROUNDED
from tests.schemas import validator

DISC = """x,y,nx,ny,mu
-0.573576436,-0.819152044,0.573576436,0.819152044,0
0.882947593,-0.469471563,-0.882947593,0.469471563,0
"""


def decimal(x, digits=9):
    whole, rest = divmod(abs(round(x * 10**digits)), 10**digits)
    return f"{'-' * (x < 0)}{whole}.{rest:0{digits}d}"


def typed(grasp):
    """Return a table of the contacts in decimals."""
    names = "x,y,nx,ny,mu" if grasp.dimension == 2 else "x,y,z,nx,ny,nz,mu"
    rows = (",".join([*map(decimal, (*c.point, *c.normal)), str(c.friction)]) for c in grasp)
    return "\n".join([names, *rows])


def on_sphere(unit, centre, radius):
    """Return a smooth contact whose normal passes a centre."""
    return Contact([x - radius * n for x, n in zip(centre, unit, strict=True)], unit, 0)


def unit2(source):
    u = F(source.randint(-40, 40), source.randint(7, 41))
    x, y = (1 - u * u) / (1 + u * u), 2 * u / (1 + u * u)
    return source.choice([(x, y), (y, x), (-x, y), (y, -x)])


def unit3(source):
    u, v = (F(source.randint(-40, 40), source.randint(7, 41)) for _ in "uv")
    square = 1 + u * u + v * v
    return (2 * u / square, (1 - u * u - v * v) / square, 2 * v / square)


def smooth_question(seed):
    """Return smooth contacts, whose normals meet in the plane and in space, and a load there."""
    source = Random(seed)
    space, size = seed % 3 == 2, source.choice([1, 30, F(1, 20)])
    centre = [F(source.randint(-99, 99), 97) * size for _ in range(3 if space else 2)]
    many = source.choice([3, 4]) if space else source.choice([2, 2, 3, 4])
    units = [unit3(source) if space else unit2(source) for _ in range(many)]
    radii = [size if seed % 2 else size * F(source.randint(1, 9), 7) for _ in units]
    grasp = Grasp(on_sphere(*one) for one in zip(units, [centre] * many, radii, strict=True))
    shares = [source.randint(0, 3) for _ in units]
    pairs = list(zip(shares, grasp, strict=True))
    load = [-sum(x * c.normal_wrench[j] for x, c in pairs) for j in range(grasp.wrench_size)]
    if seed % 5 == 4:
        load[-1] += 1
    return grasp, load


def test_disc_in_a_groove_depends_on_the_rounding(tmp_path, run):
    verdict = solve(parse_csv(DISC).grasp, (0, -1, 0))
    found = verdict.rounding
    assert (verdict.verdict, verdict.answer) == ("not resisted", "depends on the rounding")
    assert found.turned.verdict == "resisted"
    assert found.turned.verify()
    error = verdict.grasp.data_error
    assert found.change["point"] <= error.length
    assert found.change["normal"] <= error.angle
    path = tmp_path / "disc.csv"
    path.write_text(DISC)
    assert run("solve {} --weight 1", path, code=3).startswith(
        "depends on the rounding: resisted for"
    )
    printed = run("resisted {} --weight 1", path, code=3)
    assert "depends on the rounding: resisted for t in [0, oo), for other data" in printed


SEEDS = [*range(8), *(pytest.param(k, marks=pytest.mark.slow) for k in range(8, 300))]


@pytest.mark.parametrize("seed", SEEDS)
def test_exact_data_never_contradict_a_proved_answer(seed):
    exact, load = smooth_question(seed)
    expected = solve(exact, load).verdict
    text = typed(exact)
    verdict = solve(parse_csv(text).grasp, load)
    if verdict.rounding is None:  # normals were of length 1: the data are the numbers as typed
        rows = [list(map(F, line.split(","))) for line in text.split()[1:]]
        assert rows == [[*c.point, *c.normal, c.friction] for c in verdict.grasp]
    elif verdict.rounding.proved:
        assert verdict.answer == expected
    else:
        assert verdict.answer != verdict.verdict


def test_grooves_in_the_plane_are_met():
    """Wherever the exact body stands the answer says so, or that it is not proved."""
    met = 0
    for seed in range(0, 24, 3):
        exact, load = smooth_question(seed)
        verdict = solve(parse_csv(typed(exact)).grasp, load)
        if verdict.verdict == "not resisted" and solve(exact, load):
            met += verdict.answer == "depends on the rounding"
    assert met >= 2


def test_answer_that_is_not_proved_says_so(tmp_path, run):
    """One smooth contact under a load along its normal, whose length is irrational."""
    grasp = parse_csv("x,y,nx,ny,mu\n0,0,1,2,0\n").grasp
    verdict = solve(grasp, (-1, -2, 0))
    assert verdict.answer == f"not resisted {AS_ROUNDED}"
    assert verdict.to_dict()["verdict"] == "not resisted"
    assert verdict.to_dict()["within_error"]["answer"] == verdict.answer
    assert (-1, -2, 0) not in ResistedSet(grasp)
    path = tmp_path / "a.json"
    grasp.save(path)
    words = [str(path), "--wrench", "-1", "-2", "0"]
    for command, code in (("solve", 1), ("info", 1)):
        assert verdict.answer in run(command, *words, code=code)
    assert f"resisted: no, {AS_ROUNDED}" in run("resisted", *words, "--margin", code=1)
    assert run.json("solve", *words, code=1)["within_error"]["answer"] == verdict.answer


BODIES = """body_a,body_b,x,y,nx,ny,mu
disc,ground,-0.573576436,-0.819152044,0.573576436,0.819152044,0
disc,,0.882947593,-0.469471563,-0.882947593,0.469471563,0
top,ground,4,0,0,1,0.5
top,ground,6,0,0,1,0.5
"""


@pytest.mark.parametrize("form", ["csv", "json"])
def test_bodies_depend_on_the_rounding_as_a_grasp_does(form, tmp_path, run, refused):
    path = tmp_path / f"bodies.{form}"
    load = ["--on", "disc", "0", "-1", "0", "--on", "top", "0", "-1", "-5"]
    options = []
    (tmp_path / "bodies.csv").write_text(BODIES)
    if form == "json":
        run("make csv {} -o", tmp_path / "bodies.csv", path)
        document = json.loads(path.read_text())
        validator(assembly_schema()).validate(document)
        del document["data_error"]
        for entry, row in zip(document["contacts"], BODIES.splitlines()[1:], strict=True):
            entry["normal"] = row.split(",")[4:6]
        path.write_text(json.dumps(document))
        refused("solve", path, *load)
        options = ["--round-normals"]
    assert run("solve", path, *load, *options, code=3).startswith(
        "depends on the rounding: resisted for"
    )
    found = run.json("solve", path, *load, *options, code=3)
    assert found["verdict"] == found["within_error"]["answer"] == "depends on the rounding"
    # No smooth disc in a groove takes a torque.
    free = ["--on", "disc", "0", "0", "1", "--on", "top", "0", "-1", "-5"]
    printed = run("solve", path, *free, *options, "--as-given", code=1)
    assert "not resisted for all data within the rounding error" in printed


def test_rounded_bodies_are_proved_for_all(tmp_path, run):
    path, proof = tmp_path / "bodies.csv", tmp_path / "proof.json"
    # Two bodies between jaws, along a direction without a rational length.
    rows = [
        f"{pair},{x - s},{y + s / 2},{way},{2 * way},0.5,3"
        for pair, x, y, way in (("a,", 0, 0, 1), ("b,a", 1, 2, 1), ("b,", 2, 4, -1))
        for s in (1, -1)
    ]
    path.write_text("\n".join(["body_a,body_b,x,y,nx,ny,mu,q", *rows]))
    down = ["--on", "a", "0", "-0.1", "0", "--on", "b", "0", "-0.1", "-0.1"]
    assert "resisted for all data within the rounding error: proved" in run("solve", path, *down)
    held, loose = tmp_path / "bodies.csv", tmp_path / "loose.csv"
    loose.write_text("\n".join(["body_a,body_b,x,y,nx,ny,mu,q", *rows[:4]]))
    away = ["--on", "b", "1", "2.1", "0"]
    printed = run("solve", loose, *away, code=1)
    assert "not resisted for all data within the rounding error" in printed
    for path, load, kind in ((held, down, "resisted"), (loose, away, "not resisted")):
        bounds = ["--robust", "degrees=1/10", "friction=1%"]
        run("solve", path, *load, *bounds, "--certificate", proof)
        assert f"valid: {kind}, for all normals within 0.1 degrees" in run("verify", proof)


def proof_between_bodies(load):
    """Return a proof for all bodies within bounds, as a document."""
    floor = [[-5, -1], [5, -1], [5, 0], [-5, 0]]
    boxes = {name: [[0, k], [2, k], [2, k + 1], [0, k + 1]] for k, name in enumerate("ab")}
    made = Assembly.from_polygons(boxes, "1/2", ground=[floor], density=1)
    found = solve(made, {**made.weights, "b": load}).robust(degrees=1, friction="5%", length="1/99")
    return found.certificate.to_dict()


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"bounds": {"degrees": "30"}}, "larger within the bounds"),
        ({"bounds": {"friction": "99/100"}}, "no room"),
        ({"wrench": {"a": ["0", "-2", "-2"], "b": ["4", "-2", "-2"]}}, "larger within"),
    ],
)
def test_forged_proofs_between_bodies_are_refused(change, words):
    document = proof_between_bodies((0, -2, -2))
    assert check(document)
    assert words in check(document | change).problem
    no = proof_between_bodies((3, -2, -5))
    assert check(no)
    assert "work" in check(no | {"bounds": {"degrees": "40"}}).problem


def test_ends_of_bodies_depend_on_the_rounding(tmp_path, run):
    path = tmp_path / "bodies.csv"
    path.write_text(BODIES)
    on_top = ["--on", "top", "0", "-1", "-5"]
    printed = run("resisted", path, *on_top, "--along", "disc", "0", "-1", "0", code=3)
    assert "depends on the rounding: resisted for t in [0, oo), for other data" in printed
    printed = run("solve", path, *on_top, "--on", "disc", "0", "-1", "0", "--methods", code=3)
    assert "depends on the rounding: resisted for" in printed
