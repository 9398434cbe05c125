"""Grasps in space on paper, on a page, and as models."""

import json
import re
from fractions import Fraction
from io import BytesIO
from typing import Any

import numpy as np
import pytest
import trimesh

from arrangement.drawing.layout import lay_out
from arrangement.drawing.scene import Label, Path as Line, Scene
from arrangement.errors import InputError
from equilibrium import Contact, Grasp, GraspError, Mesh, ResistedSet, read_grasp
from equilibrium.decide import RESISTED, UNDECIDED
from equilibrium.pictures import draw_grasp, draw_proof, draw_slice, space_slice
from equilibrium.pictures.space_grasp import (
    Screw,
    SolidGrasp,
    drawn_in_space,
    grasp_model,
    grasp_page,
)
from equilibrium.pictures.wrench_set import (
    WALLS,
    WrenchBox,
    draw_wrench_set,
    wrench_box,
    wrench_set_model,
    wrench_set_page,
)
from equilibrium.wrench_sets.along_in_space import SpatialMagnitudes
from tests.drawn import offences
from tests.instances import PLANAR

GRASPS = ["two-opposed-fingers", "three-fingers-on-a-ball", "wedge", "peg-in-a-hole", "box-6-walls"]
WRENCH = (0, 0, -1, 0, 0, 0)


def scene_of(grasp: Grasp, **options: Any) -> Scene:
    found: Scene = draw_grasp.scene(grasp, **options)
    return found


def lines(scene: Scene, role: str) -> list[Line]:
    return [x for x in scene.items if isinstance(x, Line) and x.kind == "line" and x.role == role]


def length(items: list[Line]) -> float:
    return sum(float(np.linalg.norm(np.diff(x.points, axis=0), axis=1).sum()) for x in items)


@pytest.mark.parametrize("name", GRASPS)
def test_every_contact_numbered_within_the_page(name):
    grasp = read_grasp(name)
    scene = scene_of(grasp)
    labels = [x.text for x in scene.items if isinstance(x, Label)]
    numbers = {text for label in labels for text in label.split(", ")}
    assert numbers >= {str(i) for i in range(1, len(grasp) + 1)}
    assert offences(scene) == []
    cones = {x.name.split("-")[1] for x in scene.items if x.name.startswith("cone")}
    assert len(cones) == sum(contact.friction > 0 for contact in grasp)


def test_three_edges_of_a_cube_are_hidden_and_nine_are_seen():
    grasp = read_grasp("two-opposed-fingers")
    assert isinstance(grasp.outline, Mesh)
    scene = scene_of(grasp, camera=(3, -5, 4))
    seen, hidden = lines(scene, "edge"), lines(scene, "hidden")
    # Parallel edges have one length on paper: three quarters of all that is drawn is seen.
    assert length(seen) == pytest.approx(3 * length(hidden))
    assert all("ls" in line.style for line in hidden)
    assert not any("ls" in line.style for line in seen)


def test_missing_body_drawn_as_dashed_hull():
    scene = scene_of(read_grasp("peg-in-a-hole"))
    assert all("ls" in line.style for line in lines(scene, "edge"))
    flat = scene_of(read_grasp("three-fingers-on-a-ball"))
    assert not lines(flat, "edge")
    assert sum(x.name.startswith("link") for x in flat.items) >= 3


def test_forces_and_motion_of_an_equilibrium_are_drawn():
    grasp = read_grasp("two-opposed-fingers")
    scene = scene_of(grasp, wrench=WRENCH)
    kinds = {x.name.rsplit("-", 1)[0] for x in scene.items}
    assert kinds >= {"force-1", "force-2", "wrench-force", "preload-1"}
    refused = scene_of(grasp, wrench=(0, 0, -3, 0, 0, 0))
    assert ("not resisted", True) in refused.legend.lines
    assert not any(x.name.startswith("force") for x in refused.items)


@pytest.mark.parametrize(
    ("motion", "pitch", "point"),
    [
        ((0, 0, 2, 0, 0, 1), 2.0, (0, 0, 0)),
        ((0, -3, 0, 0, 0, 1), 0.0, (3, 0, 0)),
        ((1, 2, 3, 0, 0, 0), None, None),
        ((0, 0, 10**40, 0, 0, 10**40), 1.0, (0, 0, 0)),
    ],
)
def test_screws(motion, pitch, point):
    screw = Screw.of(tuple(map(Fraction, motion)))
    assert screw is not None
    assert screw.pitch == pitch
    assert np.linalg.norm(screw.axis) == pytest.approx(1)
    assert (screw.point is None) == (point is None)
    if screw.point is not None:
        assert screw.point == pytest.approx(point)
    assert Screw.of((0,) * 6) is None


def test_points_on_the_axis_of_a_turn_do_not_slip():
    solid = SolidGrasp(read_grasp("box-on-a-table"), (0, 0, 0, 0, 0, 1))
    corners = np.abs(solid.slips).max(axis=1)
    assert (corners > 0).all()
    assert solid.slips[:, 2] == pytest.approx(0)
    scene = drawn_in_space(solid, None, 0.0, 88.0, "")
    assert {"axis", "axis-turn"} <= {x.name.rsplit("-", 1)[0] for x in scene.items}


def test_a_proof_shows_its_virtual_motions():
    grasp = read_grasp("two-opposed-fingers")
    scene: Scene = draw_proof.scene(grasp, wrench=(0, 0, -3, 0, 0, 0))
    texts = [text for text, _ in scene.legend.lines]
    assert len(texts) == 3
    assert texts[0].startswith("1 of 3: 1 detached; λ is a rotation")
    with pytest.raises(GraspError, match="the wrench is resisted"):
        draw_proof.scene(grasp, wrench=WRENCH)


def test_a_slice_without_a_border_ends_where_the_proofs_end(monkeypatch):
    def known(grasp, way, **_):
        verdicts = [RESISTED, RESISTED, RESISTED, UNDECIDED, UNDECIDED]
        samples = zip(map(Fraction, (0, 1, 4, 16, 64)), verdicts, strict=True)
        return SpatialMagnitudes(grasp, tuple(way), (), tuple(samples), ())

    monkeypatch.setattr(space_slice, "spatial_magnitudes", known)
    fingers = read_grasp("two-opposed-fingers")
    scene: Scene = draw_slice.scene(fingers, slice=("fy", "fz"), rays=3)
    for i in range(3):
        held, undecided = (
            [x for x in scene.items if isinstance(x, Line) and x.name == f"{name}-{i}"]
            for name in ("spoke", "open")
        )
        assert length(held) == pytest.approx(4 * length(undecided))  # proved to 4, shown to 5


def test_a_slice_without_an_end_says_how_far_it_was_tried(monkeypatch):
    def known(grasp, way, **_):
        samples = ((Fraction(0), RESISTED), (Fraction(64), RESISTED))
        return SpatialMagnitudes(grasp, tuple(way), (), samples, ())

    monkeypatch.setattr(space_slice, "spatial_magnitudes", known)
    fingers = read_grasp("two-opposed-fingers")
    scene: Scene = draw_slice.scene(fingers, slice=("fy", "fz"), rays=3)
    assert scene.legend.lines[-1][0] == "unbounded as far as tested (64)"
    axis, spoke = (next(x for x in scene.items if x.name == name) for name in ("", "spoke-1"))
    assert length([spoke]) == pytest.approx(64 / 160 * length([axis]))
    assert "80" in {x.text for x in scene.items if isinstance(x, Label)}


def test_a_slice_ends_at_the_proved_borders():
    fingers = read_grasp("two-opposed-fingers")
    scene: Scene = draw_slice.scene(fingers, slice=("fy", "fz"), rays=3)
    spokes = [x for x in scene.items if x.name.startswith("spoke")]
    sizes = [float(np.linalg.norm(x.points[1] - x.points[0])) for x in spokes]
    # The fingers resist a disc of these forces.
    assert sizes == pytest.approx([sizes[0]] * 3, rel=2e-3)
    for axes in ("fx", "fx,fx", "fx,up"):
        with pytest.raises(GraspError, match="give two of"):
            draw_slice.scene(fingers, slice=axes)


def test_planar_options_refused_in_space_and_vice_versa():
    space, plane = read_grasp("wedge"), read_grasp("paper-three-contacts")
    for options in ({"outline": [(0, 0)]}, {"equilibrium": 2}, {"wrench": (0, 1, 0)}):
        with pytest.raises(GraspError):
            scene_of(space, **options)
    with pytest.raises(GraspError, match="in space"):
        scene_of(plane, camera=(1, 2, 3))
    with pytest.raises(GraspError, match="rotation"):
        draw_proof.scene(space, wrench=WRENCH, rotation=1)


def data_of(page: str) -> dict[str, Any]:
    found = re.search(r"<script[^>]*application/json[^>]*>(.*?)</script>", page, re.DOTALL)
    assert found is not None
    document: dict[str, Any] = json.loads(found[1])
    return document


def test_the_page_tells_each_contact_in_exact_numbers():
    data = data_of(grasp_page(read_grasp("wedge"), wrench=WRENCH))
    assert [piece["name"] for piece in data["pieces"]] == [f"Contact {i}" for i in (1, 2, 3, 4)]
    assert ["friction", "1/2"] in data["pieces"][0]["facts"]
    assert {face["fill"] for node in data["nodes"] for face in node["faces"]} >= {"#e69f0059"}
    assert [mark["text"] for mark in data["marks"]] == ["1", "2", "3", "4"]


def test_the_model_has_a_closed_part_for_each_arrow():
    content = grasp_model(read_grasp("two-opposed-fingers"), ".glb", wrench=WRENCH)
    scene = trimesh.load_scene(BytesIO(content), file_type="glb")
    assert {"body", "cone-1", "force-1", "force-2", "wrench-force"} <= set(scene.geometry)
    assert all(part.is_watertight for part in scene.geometry.values())
    assert scene.geometry["body"].visual.material.alphaMode == "BLEND"


def test_a_body_that_is_open_or_inside_out_is_drawn_too():
    grasp = read_grasp("two-opposed-fingers")
    assert isinstance(grasp.outline, Mesh)
    turned = [face[::-1] for face in grasp.outline.faces]
    inside_out = grasp.with_outline(Mesh(grasp.outline.vertices, turned))
    assert grasp_model(inside_out, ".stl") == grasp_model(grasp, ".stl")
    opened = grasp.with_outline(Mesh(grasp.outline.vertices, turned[1:]))
    scene_of(opened)
    assert b"body" not in grasp_model(opened, ".glb")


def test_model_has_no_cones_thinner_than_it_resolves():
    ball = read_grasp("three-fingers-on-a-ball").with_friction("1e-320")
    assert grasp_model(ball, ".stl") == grasp_model(ball.with_friction(0), ".stl")


def test_degenerate_grasps_are_drawn():
    one = Contact((0, 0, 0), (0, 0, 1), 0)
    for contacts in ([one], [one, one], [one, Contact((10**30, 0, 0), (0, 1, 0), 1, preload=1)]):
        assert "pad-1" in {item.name for item in scene_of(Grasp(contacts)).items}
        assert "<html" in grasp_page(Grasp(contacts))


PLANE_GRASPS = [
    name for name in PLANAR if any(w in name for w in ("contact", "interrupted", "slip"))
]
FLAT = ["opposed-contacts", "frictionless-opposed-contacts", "single-contact"]


def beside(
    box: WrenchBox, corners: list[tuple[Fraction, ...]], normal: tuple[int, ...], side: int
) -> list[Fraction]:
    """Return the wrench a little before or behind the middle of a patch."""
    middle = [sum(c) / len(corners) for c in zip(*corners, strict=True)]
    step = Fraction(side, 10**12 * max(map(abs, normal)))
    place = [x + step * a for x, a in zip(middle, normal, strict=True)]
    return [m + h * u for m, h, u in zip(box.middle, box.half, place, strict=True)]


@pytest.mark.parametrize("name", PLANE_GRASPS)
def test_resistance_ends_at_every_face(name):
    """Decided at exact points on both sides of faces, at most three."""
    grasp = read_grasp(name)
    box, whole = wrench_box(grasp), ResistedSet(grasp)
    patches = [p for node in box.tree for p in node.patches if len(p.corners) > 2]
    for patch in patches[:: len(patches) // 3 + 1]:
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


def sheet_of(grasp: Grasp, **options: object) -> Scene:
    scene: Scene = lay_out(draw_wrench_set.scene(grasp, **options))
    return scene


def texts(scene: Scene) -> set[str]:
    return {item.text for item in scene.items if isinstance(item, Label)}


@pytest.mark.parametrize("name", [*PLANE_GRASPS, "several-equilibria"])
def test_every_grasp_is_drawn_and_the_box_is_stated(name):
    scene = sheet_of(read_grasp(name), wrench=(0, 1, 0), width=110)
    assert any(text.startswith("box: $f_x$ ") for text in texts(scene))
    assert sum(item.name.startswith("box-") for item in scene.items) == 12
    assert offences(scene) == []


def test_a_box_of_ones_own_and_a_narrow_sheet():
    grasp = read_grasp("paper-three-contacts-preload-1")
    scene = sheet_of(grasp, extent="7/2", width=88)
    assert r"box: $f_x$ −7/2 to 7/2, $f_y$ −7/2 to 7/2, $\tau$ −7/2 to 7/2" in texts(scene)
    assert not any(item.name.startswith("cone-") for item in scene.items)
    with pytest.raises(GraspError, match="above 0"):
        draw_wrench_set(grasp, extent=0)


def test_box_below_floats_has_edges_without_numbers():
    scene = sheet_of(read_grasp("paper-three-contacts-preload-1"), extent="1e-4000", width=88)
    assert sum(item.name.startswith("box-") for item in scene.items) == 12


def test_a_wrench_is_marked_as_resisted_or_not():
    grasp = read_grasp("paper-three-contacts-preload-1")
    marks = {
        tau: next(
            item for item in sheet_of(grasp, wrench=(0, tau, 0)).items if item.name == "wrench"
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


def test_the_page_tells_exact_conditions(tmp_path, run):
    command = ["draw", "paper-three-contacts", "--view", "wrench-set"]
    run(*command, "-o", tmp_path / "a.html")
    page = (tmp_path / "a.html").read_text(encoding="utf-8")
    assert page == wrench_set_page(read_grasp("paper-three-contacts"))
    conditions = set(re.findall(r'"condition","([^"]*)"', page))
    assert any("f_y" in text and "\\u2264 0" in text for text in conditions)


def test_a_full_box_says_that_every_wrench_in_it_is_resisted():
    x, y, u, v = Fraction(39, 89), Fraction(80, 89), Fraction(33, 65), Fraction(56, 65)
    ring = [(1, 0), (x, y), (-u, v), (-u, -v), (x, -y)]
    whole = Grasp([Contact((p * Fraction(3, 2), q), (-p, -q), "1/2", 1) for p, q in ring])
    for grasp, full in ((whole, True), (read_grasp("ladder"), False)):
        scene = lay_out(draw_wrench_set.scene(grasp))
        texts = [item.text for item in scene.items if isinstance(item, Label)]
        assert any("every wrench in the box" in text for text in texts) == full
        assert ("resisted wrenches" in texts) != full
