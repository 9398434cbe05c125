"""Scenes for physics engines: bodies that stand for the law, proofs, files, MuJoCo."""

import json
import math
from fractions import Fraction
from functools import cache
from importlib import metadata
from itertools import islice
from pathlib import Path
from xml.etree import ElementTree as ET
from zipfile import ZipFile

import numpy as np
import pytest

from equilibrium import Contact, Grasp, Polygon, read_grasp
from equilibrium.certificate.checker import check
from equilibrium.certificate.law import frame
from equilibrium.decide.solver import Solver
from equilibrium.scenes import EngineScene, benchmark, document_text
from proofs_check.cli import main as claims
from tests.docpages import ROOT

NAME = "paper-three-contacts-preload-1"
PAPER = read_grasp("paper-three-contacts-preload-1")
BALL = read_grasp("three-fingers-on-a-ball")
UP = {2: [0, 1, 0], 3: [0, 0, 1, 0, 0, 0]}


@cache
def load_up(grasp):
    """What the document of a scene says of a load upwards."""
    (load,) = EngineScene(grasp, [UP[grasp.dimension]]).document()["loads"]
    return load


@pytest.mark.parametrize("grasp", [PAPER, BALL])
def test_each_verdict_has_its_proof(grasp):
    load = load_up(grasp)
    answers = []
    for entry in load["verdicts"]:
        wrench = [Fraction(entry["magnitude"]) * x for x in UP[grasp.dimension]]
        assert check(entry["certificate"], (grasp, wrench)).kind == entry["verdict"]
        answers.append(entry["verdict"])
    assert answers == sorted(answers, reverse=True)
    assert set(answers) == {"resisted", "not resisted"}


def test_ends_exact_in_plane_and_bracketed_in_space():
    flat, spatial = load_up(PAPER), load_up(BALL)
    assert flat["resisted"] == [["0", "1"]]
    assert [x["magnitude"] for x in flat["verdicts"]] == ["63/64", "1", "65/64"]
    (border,) = spatial["borders"]
    low, high = Fraction(border["resisted"]), Fraction(border["not_resisted"])
    assert low <= Fraction(4, 3) <= high <= low * (1 + Fraction(1, 500))


def test_stiffer_springs_leave_every_verdict():
    scene = EngineScene(PAPER, [[0, 1, 0]])
    times = Fraction(scene.stiffening)
    stiff = Grasp(
        Contact(c.point, c.normal, c.friction, c.stiffness * times, c.preload) for c in PAPER
    )
    for t in ("63/64", 1, "65/64", 3):
        load = [0, Fraction(t), 0]
        soft, hard = Solver(PAPER).solve(load), Solver(stiff).solve(load)
        assert soft.stable == hard.stable == (Fraction(t) <= 1)


@pytest.mark.parametrize("name", ["all-contacts-stick", "peg-in-a-hole", "unchecked-cell"])
def test_fingers_touch_pads_with_the_preload(name):
    grasp = read_grasp(name)
    root = ET.fromstring(EngineScene(grasp).mjcf())
    numbers = lambda element, key: np.array([float(x) for x in element.get(key).split()])  # noqa: E731
    pads = root.findall(".//body[@name='object']/geom")
    fingers = [b for b in root.findall("worldbody/body") if b.get("name") != "object"]
    assert len(pads) == len(fingers) == len(root.findall("contact/pair")) == len(grasp)
    for contact, pad, finger in zip(grasp, pads, fingers, strict=True):
        point, normal = (
            np.pad([float(x) for x in v], (0, 3 - len(v))) for v in (contact.point, contact.normal)
        )
        ball, spring = finger.find("geom"), finger.find("joint")
        assert np.allclose(numbers(finger, "pos") + float(ball.get("size")) * normal, point)
        face = numbers(pad, "pos") - numbers(pad, "size")[2] * numbers(pad, "zaxis")
        assert np.allclose(face, point)
        assert np.allclose(numbers(pad, "zaxis"), normal)
        assert np.allclose(numbers(spring, "axis"), normal)
        pushes = float(spring.get("stiffness")) * float(spring.get("springref"))
        assert math.isclose(pushes, contact.preload, abs_tol=1e-12)
    gears = [numbers(x, "gear") for x in root.findall("actuator/general")]
    assert len(gears) == (3 if grasp.dimension == 2 else 6)


def test_frictionless_contact_has_no_tangent():
    corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]]
    grasp = Grasp([Contact([-1, 0], [1, 0], 0)], outline=Polygon(corners))
    root = ET.fromstring(EngineScene(grasp).mjcf())
    assert root.find("contact/pair").get("condim") == "1"
    seen = root.findall(".//geom[@type='capsule']")
    assert len(seen) == 4
    assert {x.get("contype") + x.get("conaffinity") for x in seen} == {"00"}


@pytest.mark.parametrize(
    ("grasp", "directions", "words"),
    [
        (Grasp(), None, "without contacts"),
        (PAPER, [[0, 0, 0]], "zero"),
        (PAPER, [[10**10, 0, 0]], "10^9"),
        (Grasp([Contact([10**400, 0], [1, 0], 1)]), None, "10^9"),
        (Grasp([Contact([0, 0], [1, 0], 1, Fraction(1, 10**12))]), None, "10^-9"),
    ],
)
def test_what_engines_do_not_take_is_refused(grasp, directions, words):
    with pytest.raises(ValueError, match=words.replace("^", r"\^")):
        EngineScene(grasp, directions)


def test_the_command_writes_scenes(tmp_path, run):
    path = tmp_path / "scene.json"
    run("draw {} --model scene -o", NAME, path)
    document = json.loads(path.read_text())
    assert document == json.loads(document_text(EngineScene(PAPER).document()))
    assert Grasp.from_dict(document["grasp"]) == PAPER
    load = ["--force", "0", "1", "--at", "0", "0"]
    xml = tmp_path / "scene.xml"
    run("draw {} --model scene -o", NAME, xml, *load)
    assert xml.read_text() == EngineScene(PAPER, [[0, 1, 0]]).mjcf()


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        ("--model scene -o x.stl", "the output is 'x.stl'"),
        ("--model grasp -o x.xml", "the output is 'x.xml'"),
        ("-o x.json", "the output is 'x.json'; expected .json of --view slice"),
        ("--model scene -o x.xml --font-size 8pt", "take no --font-size"),
        ("--model scene -o x.xml --slice fx fy", "take no --slice"),
        ("--view slice -o x.json --preload 1", "take no --preload"),
        ("--view slice -o x.svg --origin 0 0 1", "write them with -o FILE.json"),
        ("--view slice -o x.json --slice fx", "--slice has 1 wrench; expected two"),
        ("--view slice -o x.json --slice fx fz", "expected one of fx, fy, tau"),
    ],
)
def test_options_that_data_do_not_take_are_refused(words, reason, refused):
    assert reason in refused("draw", NAME, *words.split())


@pytest.mark.slow
def test_the_benchmark_has_sixty_scenes_that_rest():
    scenes = dict(benchmark())
    assert len(scenes) == 60
    assert sum(scene.grasp.dimension == 2 for scene in scenes.values()) == 40
    sizes = {len(scene.grasp) for name, scene in scenes.items() if name.startswith("plane-random")}
    assert sizes == set(range(3, 9))
    for scene in scenes.values():
        zero = [0] * len(scene.directions[0])
        assert len(scene.directions) == 3
        assert Solver(scene.grasp).solve(zero).stable


@pytest.mark.slow
def test_the_archive_of_the_page_has_the_scenes_and_proofs():
    """Some are made again: the archive has their loads and verdicts, maybe with other proofs."""
    scenes = dict(benchmark())
    with ZipFile(ROOT / "docs" / "howto" / "slip-scenes.zip") as archive:
        assert archive.namelist() == [f"slip-scenes/{name}.json" for name in scenes]
        for name, scene in islice(scenes.items(), 0, None, 12):
            kept = json.loads(archive.read(f"slip-scenes/{name}.json"))
            made = json.loads(document_text(scene.document()))
            for load in kept["loads"]:
                for entry in load["verdicts"]:
                    wrench = [Fraction(entry["magnitude"]) * Fraction(x) for x in load["direction"]]
                    proof = entry.pop("certificate")
                    assert check(proof, (scene.grasp, wrench)).kind == entry["verdict"]
            for load in made["loads"]:
                for entry in load["verdicts"]:
                    del entry["certificate"]
            assert kept == made, name


@pytest.fixture
def benchmarks(monkeypatch):
    """The folder of what is measured, where modules of it are found."""
    folder = Path(__file__).parents[1] / "benchmarks"
    monkeypatch.syspath_prepend(folder)
    return folder


def test_an_engine_without_friction_holds_nothing(benchmarks):
    from engines import Setting
    from simulators import slip_load

    def without_friction(scene, load, damping):
        axes = np.array([[float(x) for x in frame(c)[0]] for c in scene.grasp])
        stiffness, preload = (
            np.array([f[key] for f in scene.fingers]) for key in ("stiffness", "preload")
        )
        push = np.array([float(x) for x in scene.directions[load]])
        place, damped = np.zeros(3), damping * np.array([1, 1, scene.size**2])

        def advance(seconds, t, pressed):
            for _ in range(round(seconds / 0.01)):
                springs = np.maximum(0, preload * pressed - stiffness * (axes @ place))
                place[:] += 0.01 * (t * push + springs @ axes) / damped
            return place.copy()

        return advance

    setting = Setting("own", "no friction", without_friction, {}, (2,))
    for direction, held in (([0, 1, 0], False), ([0, -1, 0], True)):
        scene = EngineScene(PAPER, [direction])
        for together in (True, False):
            found, _ = slip_load(scene, 0, 1.0, setting, together)
            assert found is None if held else found < 0.01


def test_claims_on_an_engine_that_is_missing_have_no_verdict(benchmarks, monkeypatch, capsys):
    def missing(name):
        raise metadata.PackageNotFoundError(name)

    monkeypatch.setattr(metadata, "version", missing)
    assert claims(["run", str(benchmarks / "engine_claims.py"), "--json"]) == 2
    told = capsys.readouterr()
    assert json.loads(told.out)["results"] == []
    assert told.err.count("no verdict: not tried: needs the extra simulators") == 2


@pytest.mark.slow
def test_mujoco_reads_scenes_and_slips_near_the_exact_load():
    import mujoco  # the extra simulators, which make test-extended installs

    for _, scene in islice(benchmark(), 0, None, 7):
        model = mujoco.MjModel.from_xml_string(scene.mjcf())
        assert model.npair == len(scene.grasp)
        assert model.nu == 3
    text = (
        EngineScene(PAPER, [[0, 1, 0]])
        .mjcf()
        .replace("<option", '<option impratio="100" cone="elliptic"')
    )
    model = mujoco.MjModel.from_xml_string(text)
    moved = {}
    for t in (0.9, 1.1):
        data = mujoco.MjData(model)
        for part in range(4000):
            data.ctrl[0] = t * min(1, part / 2000)
            mujoco.mj_step(model, data)
        moved[t] = data.qvel[1] * EngineScene(PAPER).damping / t
    assert abs(moved[0.9]) < 0.01 < 0.05 < moved[1.1]
