"""Cells as models: cut exactly, closed, of the stated size, and together as large as the body."""

import json
import math
import struct
from collections import Counter
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings, strategies as st

from arrangement import Arrangement, ArrangementError, InputError
from arrangement.cli import main
from arrangement.counts import region_count
from arrangement.drawing.solids.meshes import ClosedSurface, model_bytes
from arrangement.duals.body import body_around
from arrangement.duals.cells import Cells, cut_cells
from arrangement.library.files.table import read_arrangement
from arrangement.numbers.exact import sign
from arrangement.numbers.linear.rank import determinant
from arrangement.pictures import write_drawing

from .strategies import arrangements

AFFINE = Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1], [2, -1, 1]], [0, 0, 0, 1, "1/3"])
CASES = {
    "A3": read_arrangement("braid-a3"),
    "pencil": read_arrangement("pencil"),
    "coincident": read_arrangement("paper-four-contacts"),
    "affine": AFFINE,
    "no planes": Arrangement([], dimension=3),
}
spatial = arrangements(dimensions=(3, 3), planes=(0, 5))
TETRAHEDRON = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3))


def corners(cells: Cells) -> list[tuple[Fraction, ...]]:
    return [tuple(Fraction(x, p[3]) for x in p[:3]) for p in cells.points]


def volume(points: list[tuple[Fraction, ...]], faces: Any) -> Fraction:
    """Return the exact volume of a closed surface, by cones over its faces."""
    total = Fraction(0)
    for face in faces:
        for k in range(1, len(face) - 1):
            (a, b, c), (d, e, f), (g, h, i) = (points[face[j]] for j in (0, k, k + 1))
            total += a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    return total / 6


@given(spatial)
def test_cells_of_a_cube_are_closed_convex_and_fill_it_exactly(planes):
    cells = cut_cells(planes, "cube")
    points = corners(cells)
    volumes = [volume(points, cell.faces) for cell in cells.cells]
    assert min(volumes) > 0
    assert sum(volumes) == 8 * cells.body.radius**3
    for cell in cells.cells:
        edges = Counter(e for f in cell.faces for e in zip(f, (*f[1:], f[0]), strict=True))
        assert set(edges.values()) == {1}
        assert all((b, a) in edges for a, b in edges)
        used = {i for face in cell.faces for i in face}
        assert len(used) - len(edges) // 2 + len(cell.faces) == 2
        for face in cell.faces:
            assert len(set(face)) == len(face) > 2
            assert all(side(cells.points, face, i) == (0 if i in face else -1) for i in used)
        for i in used:
            signs = planes.signs_at(points[i])
            assert all(s in (0, own) for s, own in zip(signs, cell.signs, strict=True))


def side(points: Any, face: tuple[int, ...], i: int) -> int:
    """Return the sign of a point on the plane of a face: 1 outside, -1 inside."""
    return -sign(determinant([points[k] for k in (*face[:3], i)]))


def test_the_ball_is_convex_and_its_corners_lie_on_the_sphere_exactly():
    body = body_around(Arrangement([], dimension=3), "ball")
    assert all(x * x + y * y + z * z == w * w for x, y, z, w in body.corners)
    across: dict[tuple[int, int], int] = {}
    for a, b, c in body.faces:
        for p, q, r in ((a, b, c), (b, c, a), (c, a, b)):
            assert (p, q) not in across
            across[p, q] = r
    assert len(body.corners) - len(across) // 2 + len(body.faces) == 2
    for (p, q), r in across.items():
        rows = [body.corners[i] for i in (p, q, r, across[q, p])]
        assert determinant(rows) > 0


@settings(max_examples=15)
@given(spatial, st.sampled_from(["ball", "cube"]))
def test_the_body_contains_every_lowest_face(planes, kind):
    body = body_around(planes, kind)
    cells = cut_cells(planes, kind)
    assert len(cells.cells) == region_count(planes)
    if planes.rank == 3:
        for face in planes.faces(0):
            apart = [x - c for x, c in zip(face.witness, body.centre, strict=True)]
            assert sum(x * x for x in apart) * 16 <= 9 * body.radius**2


def loaded(path: Path) -> Any:
    return trimesh.load(path, force="mesh")


def shells(path: Path) -> list[Any]:
    return list(loaded(path).split(only_watertight=False))


@pytest.mark.campaign
@pytest.mark.parametrize("body", ["ball", "cube"])
@pytest.mark.parametrize("name", CASES)
def test_the_shells_of_an_stl_are_closed_and_together_as_large_as_the_body(name, body, tmp_path):
    path = tmp_path / "cells.stl"
    write_drawing(CASES[name], path, model="cells", body=body, size=40, explode=1.5)
    parts = shells(path)
    assert len(parts) == region_count(CASES[name])
    for part in parts:
        assert part.is_watertight
        assert part.is_winding_consistent
        assert part.volume > 0
    total = math.fsum(part.volume for part in parts)
    if body == "cube":
        assert total == pytest.approx(40**3, rel=1e-6)
    else:
        ball = math.pi / 6 * 40**3
        assert 0.997 * ball < total < ball
        whole = cut_cells(Arrangement([], dimension=3), "ball")
        mesh = float(volume(corners(whole), whole.cells[0].faces))
        assert total == pytest.approx(mesh * 20**3, rel=1e-5)


def glb(path: Path) -> dict[str, Any]:
    content = path.read_bytes()
    magic, version, length = struct.unpack("<4sII", content[:12])
    assert (magic, version, length) == (b"glTF", 2, len(content))
    (size, kind) = struct.unpack("<I4s", content[12:20])
    assert kind == b"JSON"
    document: dict[str, Any] = json.loads(content[20 : 20 + size])
    return document


def test_glb_has_a_named_node_for_each_region_in_metres(tmp_path):
    planes = CASES["affine"]
    path = tmp_path / "cells.glb"
    write_drawing(planes, path, model="cells", body="cube", size=80, explode=1)
    document = glb(path)
    names = [node["name"] for node in document["nodes"][1:]]
    signs = ["".join("+" if s > 0 else "-" for s in face.signs) for face in planes.regions()]
    assert sorted(names) == sorted(signs)
    assert all(node["extras"] == {"signs": node["name"]} for node in document["nodes"][1:])
    assert document["asset"]["extras"]["unit"] == "metre"
    assert loaded(path).extents == pytest.approx([0.08] * 3)
    used = {p["material"] for mesh in document["meshes"] for p in mesh["primitives"]}
    assert used == set(range(len(document["materials"])))
    assert len(used) == len(planes.distinct) + 1


def test_glb_and_stl_hold_the_same_solids_the_first_with_y_upward(tmp_path):
    for suffix in ("glb", "stl", "obj"):
        write_drawing(CASES["A3"], tmp_path / f"cells.{suffix}", model="cells", body="cube")
    stl, open_parts = loaded(tmp_path / "cells.stl"), loaded(tmp_path / "cells.glb")
    turned = trimesh.Trimesh(open_parts.vertices * 1000, open_parts.faces)
    assert turned.is_watertight
    obj = loaded(tmp_path / "cells.obj")
    assert obj.bounds == pytest.approx(stl.bounds)
    assert obj.volume == pytest.approx(stl.volume)
    assert turned.volume == pytest.approx(stl.volume, rel=1e-4)
    centres = [p.center_mass for p in stl.split()]
    others = [p.center_mass for p in turned.split()]
    back = np.array([[x, -z, y] for x, y, z in others])
    gaps = np.linalg.norm(np.array(centres)[:, None] - back, axis=2).min(axis=1)
    assert gaps.max() < 1e-3


def test_parts_move_outward_by_the_stated_factor(tmp_path):
    planes = read_arrangement("coordinate-planes")
    centres: dict[float, Any] = {}
    for explode in (1.5, 2):
        path = tmp_path / "cells.stl"
        write_drawing(planes, path, model="cells", body="cube", size=40, explode=explode)
        centres[explode] = sorted(tuple(np.round(p.center_mass, 3)) for p in shells(path))
    signs = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    assert centres[1.5] == sorted((15.0 * x, 15.0 * y, 15.0 * z) for x, y, z in signs)
    assert centres[2] == sorted((20.0 * x, 20.0 * y, 20.0 * z) for x, y, z in signs)


@pytest.mark.campaign
@pytest.mark.parametrize("model", ["cells", "dual"])
@pytest.mark.parametrize("suffix", [".stl", ".glb", ".obj"])
def test_models_repeat_byte_for_byte(model, suffix, tmp_path):
    for name in "ab":
        write_drawing(CASES["A3"], tmp_path / f"{name}{suffix}", model=model, size=50)
    assert (tmp_path / f"a{suffix}").read_bytes() == (tmp_path / f"b{suffix}").read_bytes()


@pytest.mark.parametrize("model", ["cells", "dual"])
def test_stl_and_obj_say_that_they_are_in_millimetres(model, tmp_path):
    for suffix in (".stl", ".obj"):
        path = tmp_path / f"a{suffix}"
        assert main(["draw", "braid-a3", "-o", str(path), "--model", model, "--size", "25.5"]) == 0
        assert b"unit: millimetre" in path.read_bytes()[:80]
    header = (tmp_path / "a.stl").read_bytes()[:80]
    assert not header.startswith(b"solid")


def test_faces_of_the_dual_have_the_colour_of_their_number_of_corners(tmp_path):
    """The dual of A3 has 6 squares and 8 hexagons: 12 and 32 triangles."""
    path = tmp_path / "dual.glb"
    write_drawing(CASES["A3"], path, size=25.5)
    document = glb(path)
    (mesh,) = document["meshes"]
    counts = {
        p["material"]: document["accessors"][p["indices"]]["count"] // 3 for p in mesh["primitives"]
    }
    assert sorted(counts.values()) == [12, 32]
    assert max(loaded(path).extents) == pytest.approx(0.0255)


def test_colours_of_models_are_hexadecimal(tmp_path):
    with pytest.raises(InputError, match="#rrggbb"):
        write_drawing(CASES["A3"], tmp_path / "a.glb", model="cells", colour=lambda _: "red")
    assert list(tmp_path.iterdir()) == []


def test_points_that_rounding_joins_leave_a_closed_surface_or_are_refused():
    corner = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    split = np.concatenate([corner, [[1e-12, 0, 0]]])
    faces = ((0, 2, 1), (4, 1, 3), (1, 2, 3), (2, 0, 3), (0, 1, 4), (0, 4, 3))
    text = model_bytes([ClosedSurface("a", split, faces, ("#ffffff",) * 6)], ".obj", "t").decode()
    assert text.count("\nv ") == 4
    assert text.count("\nf ") == 4
    flat = corner * [1, 1, 1e-12]
    with pytest.raises(ArrangementError, match="too thin"):
        model_bytes([ClosedSurface("a", flat, TETRAHEDRON, ("#ffffff",) * 4)], ".stl", "t")
