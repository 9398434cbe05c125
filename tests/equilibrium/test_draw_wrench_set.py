"""The resisted wrenches in space: the surface that is drawn is where resistance ends."""

import re
from fractions import Fraction

import pytest

from arrangement.drawing.scene.layout import laid_out
from arrangement.drawing.scene.scene import Label, Scene
from arrangement.errors import InputError
from equilibrium import Contact, GraspError, read_grasp
from equilibrium.cli.program import main
from equilibrium.model.grasp import Grasp
from equilibrium.pictures.wrenches.wrench_box import WALLS, WrenchBox, wrench_box
from equilibrium.pictures.wrenches.wrench_page import wrench_set_model, wrench_set_page
from equilibrium.pictures.wrenches.wrench_set import draw_wrench_set
from equilibrium.wrench_sets import resisted_set
from tests.drawn import offences
from tests.instances import PLANAR

GRASPS = [name for name in PLANAR if any(w in name for w in ("contact", "interrupted", "slip"))]
FLAT = ["opposed-contacts", "frictionless-opposed-contacts", "single-contact"]


def beside(
    box: WrenchBox, corners: list[tuple[Fraction, ...]], normal: tuple[int, ...], side: int
) -> list[Fraction]:
    """Return the wrench a little before or behind the middle of a patch."""
    middle = [sum(c) / len(corners) for c in zip(*corners, strict=True)]
    step = Fraction(side, 10**12 * max(map(abs, normal)))
    place = [x + step * a for x, a in zip(middle, normal, strict=True)]
    return [m + h * u for m, h, u in zip(box.middle, box.half, place, strict=True)]


@pytest.mark.parametrize("name", GRASPS)
def test_resistance_ends_at_every_face(name):
    """Decided at exact points on both sides of each face."""
    grasp = read_grasp(name)
    box, whole = wrench_box(grasp), resisted_set(grasp)
    patches = [p for node in box.tree for p in node.patches if len(p.corners) > 2]
    for patch in patches:
        corners = [tuple(Fraction(x, c[3]) for x in c[:3]) for c in patch.corners]
        behind = whole.contains(beside(box, corners, patch.row[:3], -1))
        before = whole.contains(beside(box, corners, patch.row[:3], 1))
        if patch.sheet:
            assert not behind
            assert not before
        else:
            assert behind
            assert before == (patch.row in WALLS)
    assert bool(patches) == (name != "frictionless-opposed-contacts")


def scene_of(grasp: Grasp, **options: object) -> Scene:
    scene: Scene = laid_out(draw_wrench_set.scene(grasp, **options))
    return scene


def texts(scene: Scene) -> set[str]:
    return {item.text for item in scene.items if isinstance(item, Label)}


@pytest.mark.parametrize("name", [*GRASPS, "several-equilibria"])
def test_every_grasp_is_drawn_and_the_box_is_stated(name):
    scene = scene_of(read_grasp(name), wrench=(0, 1, 0), width=110)
    assert any(text.startswith("box: $f_x$ ") for text in texts(scene))
    assert sum(item.name.startswith("box-") for item in scene.items) == 12
    assert offences(scene) == []


def test_a_box_of_ones_own_and_a_narrow_sheet():
    grasp = read_grasp("paper-three-contacts-preload-1")
    scene = scene_of(grasp, extent="7/2", width=88)
    assert r"box: $f_x$ −7/2 to 7/2, $f_y$ −7/2 to 7/2, $\tau$ −7/2 to 7/2" in texts(scene)
    assert not any(item.name.startswith("cone-") for item in scene.items)
    with pytest.raises(GraspError, match="above 0"):
        draw_wrench_set(grasp, extent=0)


def test_a_wrench_is_marked_as_resisted_or_not():
    grasp = read_grasp("paper-three-contacts-preload-1")
    marks = {
        tau: next(
            item for item in scene_of(grasp, wrench=(0, tau, 0)).items if item.name == "wrench"
        )
        for tau in (1, 2)
    }
    assert (marks[1].sign, marks[2].sign) == ("o", "x")


@pytest.mark.parametrize("suffix", [".stl", ".obj", ".glb"])
def test_models_have_one_closed_part_for_each_polyhedron(suffix):
    grasp = read_grasp("paper-four-contacts-preload-1")
    content = wrench_set_model(grasp, suffix)
    assert content == wrench_set_model(grasp, suffix)
    if suffix == ".obj":
        solid = [s for s in wrench_box(grasp).shapes if s.dimension == 3]
        assert content.count(b"\no ") == len(solid)


@pytest.mark.parametrize("name", FLAT)
def test_a_set_without_volume_is_no_model(name):
    with pytest.raises(InputError, match="no volume"):
        wrench_set_model(read_grasp(name), ".stl")


def test_the_page_tells_exact_conditions(tmp_path):
    command = ["draw", "paper-three-contacts", "--view", "wrench-set"]
    assert main([*command, "-o", str(tmp_path / "a.html")]) == 0
    page = (tmp_path / "a.html").read_text(encoding="utf-8")
    assert page == wrench_set_page(read_grasp("paper-three-contacts"))
    conditions = set(re.findall(r'"condition","([^"]*)"', page))
    assert any("f_y" in text and "\\u2264 0" in text for text in conditions)


def test_a_full_box_says_that_every_wrench_in_it_is_resisted():
    x, y, u, v = Fraction(39, 89), Fraction(80, 89), Fraction(33, 65), Fraction(56, 65)
    ring = [(1, 0), (x, y), (-u, v), (-1, 0), (-u, -v), (x, -y)]
    whole = Grasp([Contact((p * Fraction(3, 2), q), (-p, -q), "1/2", 1) for p, q in ring])
    for grasp, full in ((whole, True), (read_grasp("ladder"), False)):
        scene = laid_out(draw_wrench_set.scene(grasp))
        texts = [item.text for item in scene.items if isinstance(item, Label)]
        assert any("every wrench in the box" in text for text in texts) == full
        assert ("resisted wrenches" in texts) != full
