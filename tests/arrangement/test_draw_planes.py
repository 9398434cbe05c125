"""Planes in a ball or cube: the order of painting is right, what is drawn is what is counted."""

import json
import math
import random
import re
import struct
from collections import Counter
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path as FilePath
from typing import Any

import numpy as np
import pytest
import shapely
import trimesh
from hypothesis import given, strategies as st

from arrangement import Arrangement, ArrangementError, read_arrangement
from arrangement.counts import f_vector, region_count
from arrangement.drawing.scene import Path
from arrangement.drawing.solids.meshes import ClosedSurface, model_bytes
from arrangement.duals.cells import Cells, body_around, cut_cells
from arrangement.errors import InputError
from arrangement.library.families.classical import golden_ratio
from arrangement.numbers.exact import sign
from arrangement.numbers.linear.rank import determinant
from arrangement.pictures import (
    arrangement_page,
    cells_page,
    draw_lines,
    draw_sphere,
    write_drawing,
)
from arrangement.pictures.cells import cells_model
from arrangement.pictures.coordinates import in_space
from arrangement.pictures.planes import PlanesSheet, draw_planes
from arrangement.pictures.stage import Facet, Lifted, Stage, StagedAxes, lifted_cells
from arrangement.pictures.views import DRAWINGS
from tests.drawn import paths
from tests.instances import PLANAR

from .strategies import arrangements

Point = tuple[Fraction, ...]
#: Five affine planes in general position, with bounded regions.
AFFINE = Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1], [2, -1, 1]], [0, 0, 0, 1, "1/3"])
_GOLDEN = golden_ratio()
#: The same with irrational entries.
IRRATIONAL = Arrangement(
    [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, _GOLDEN[0], 1], [2, -1, _GOLDEN[1]]], [0, 0, 0, 1, "1/3"]
)
DIRECTION = (5, 3, 4)
spatial = arrangements(dimensions=(3, 3), planes=(1, 5))


def exact(cells: Any, corner: int) -> Point:
    x, y, z, w = cells.points[corner]
    return Fraction(x, w), Fraction(y, w), Fraction(z, w)


def wrong_pairs(stage: Stage, facets: Sequence[Facet], samples: random.Random) -> list[Any]:
    """Find facets that are painted after one in front of them, by exact depths on lines of sight.

    Only positions and sign vectors of points are used, not the keys of the order.
    """
    planes = stage.arrangement
    body = stage.cells.body
    rows = list(zip(planes.normals, planes.offsets, strict=True))
    v = stage.direction
    position = {stage.arrangement.over_planes(facet.sides): i for i, facet in enumerate(facets)}
    wrong = []
    for i, facet in enumerate(facets):
        weights = [Fraction(samples.randint(1, 9)) for _ in facet.corners]
        corners = [exact(stage.cells, corner) for corner in facet.corners]
        p = [
            sum((w * c[k] for w, c in zip(weights, corners, strict=True)), Fraction(0))
            / sum(weights)
            for k in range(3)
        ]
        for normal, offset in rows:
            slope = sum(a * b for a, b in zip(normal, v, strict=True))
            if not slope:
                continue
            t = (offset - sum(a * b for a, b in zip(normal, p, strict=True))) / slope
            q = [a + t * b for a, b in zip(p, v, strict=True)]
            apart = [(a - c) / body.radius for a, c in zip(q, body.centre, strict=True)]
            inside = (
                max(map(abs, apart)) < 1
                if body.kind == "cube"
                else sum(x * x for x in apart) < Fraction(99, 100)
            )
            other = position.get(planes.signs_at(q))
            if inside and t and other is not None and (t > 0) != (other > i):
                wrong.append((i, other))
    return wrong


@pytest.mark.slow
@given(
    spatial,
    st.tuples(*[st.integers(-3, 3)] * 3).filter(any),
    st.sampled_from(["ball", "cube"]),
    st.randoms(use_true_random=False),
)
def test_no_facet_is_painted_after_one_in_front_of_it(planes, direction, body, samples):
    stage = Stage(cut_cells(planes, body), direction)
    assert wrong_pairs(stage, stage.facets, samples) == []


@pytest.mark.parametrize("name", ["braid-a3", "reflection-b3"])
def test_the_check_of_the_order_finds_a_wrong_order(name):
    stage = Stage(cut_cells(read_arrangement(name), "cube"), DIRECTION)
    assert wrong_pairs(stage, stage.facets, random.Random(1)) == []
    assert wrong_pairs(stage, stage.facets[::-1], random.Random(1))


@given(spatial, st.sampled_from(["ball", "cube"]))
def test_every_facet_and_every_region_meets_the_body(planes, body):
    """Zaslavsky's theorem counts them by another route."""
    cells = cut_cells(planes, body)
    _, _, facets, regions = f_vector(planes)
    assert len(cells.cells) == regions
    assert {cell.signs for cell in cells.cells} == {face.signs for face in planes.regions()}
    stage = Stage(cells, DIRECTION)
    assert len(stage.facets) == facets
    found = {stage.arrangement.over_planes(facet.sides) for facet in stage.facets}
    assert found == {face.signs for face in planes.faces(2)}


@pytest.mark.parametrize("planes", [read_arrangement("braid-a3"), AFFINE], ids=["A3", "affine"])
def test_facets_of_a_plane_fill_its_disc_in_the_ball(planes):
    stage = Stage(cut_cells(planes, "ball"), DIRECTION)
    for label, (_, offset) in enumerate(stage.planes):
        found = sum(area(stage.points[list(f.corners)]) for f in stage.facets if f.label == label)
        disc = np.pi * (1 - offset**2)
        assert 0.996 * disc < found < disc


def area(corners: Any) -> float:
    steps = corners[1:] - corners[0]
    return float(np.linalg.norm(np.cross(steps[:-1], steps[1:]).sum(axis=0))) / 2


def painted(figure: Any, start: str) -> dict[str, float]:
    """Return the names that begin with `start` and when they are painted."""
    return {path.name: path.height for path in paths(figure) if path.name.startswith(start)}


@pytest.mark.parametrize(
    ("planes", "numbers"),
    [
        (read_arrangement("braid-a3"), [0, 5, 14, 23]),
        (AFFINE, range(0, 24, 3)),
        (IRRATIONAL, range(0, 24, 3)),
    ],
    ids=["A3", "affine", "irrational"],
)
@pytest.mark.parametrize("direction", [(5, 3, 4), (-2, 5, 1), (1, -6, -3)])
def test_lifted_cells_painted_in_depth_order(planes, numbers, direction):
    """Lines of sight through the middles of facets and of lifted cells meet the rest in order."""
    chosen = [planes.regions()[number].signs for number in numbers]
    stage = Stage(cut_cells(planes, "cube"), direction)
    lifted = lifted_cells(stage, chosen)
    sheet = PlanesSheet(stage, lifted, lambda _: "#ffffff", 88.0, StagedAxes(stage, ()))
    shapes: dict[str, list[tuple[float, Any]]] = {}
    for item in sheet.scene.items:
        if isinstance(item, Path) and item.kind == "polygon":
            shapes.setdefault(item.name, []).append((item.height, shapely.Polygon(item.points)))

    def painted_at(solid: Lifted, point: Any) -> float:
        """Return when the face of a solid is painted that the line of sight enters."""
        name = "cell-" + "".join("+" if s > 0 else "-" for s in solid.cell.signs)
        at = shapely.Point(sheet.place(point))
        return max(z for z, shape in shapes[name] if shape.intersects(at))

    things: list[tuple[float, Any, Any]] = []
    for i, facet in enumerate(stage.facets):
        ((z, _),) = shapes[f"facet-{i}-plane-{facet.label + 1}"]
        things.append((z, stage.points[list(facet.corners)].mean(axis=0), None))
    for solid in lifted:
        middle = solid.corners.mean(axis=0)
        things.append((painted_at(solid, middle), middle, solid))
    met = 0
    for z, point, own in things:
        for solid in lifted:
            interval = sight_through(solid, point)
            if solid is own or interval is None:
                continue
            low, high = interval
            assert not low < point[2] < high
            met += 1
            assert (z > painted_at(solid, point)) == (point[2] > high)
    assert met


def sight_through(solid: Any, point: Any) -> tuple[float, float] | None:
    """Return the depths between which the line of sight through a point is inside a solid."""
    low, high = -np.inf, np.inf
    for face, normal in zip(solid.cell.faces, solid.normals, strict=True):
        free = normal @ (solid.points[face[0]] - [point[0], point[1], 0.0])
        if abs(normal[2]) < 1e-12:
            if free < 0:
                return None
        elif normal[2] > 0:
            high = min(high, free / normal[2])
        else:
            low = max(low, free / normal[2])
    return (float(low), float(high)) if high - low > 1e-9 else None


def test_coincident_planes_share_a_number_place():
    axes = draw_planes(read_arrangement("paper-four-contacts"), body="cube", axes="none").axes[0]
    assert sorted(text.get_text() for text in axes.texts) == ["1,2", "3,4"]


def test_the_command_takes_signs_that_begin_with_a_minus(tmp_path, run):
    target = tmp_path / "a.svg"
    arguments = ["draw", "coordinate-planes", "-o", str(target), "--view", "planes"]
    more = ["--lift=-+-", "--lift=---", "--body", "cube", "--camera", "-1/2", "3", "0.7"]
    assert '"view": "planes"' in run(*arguments, *more, "--width", "120", "--json")
    assert b"cell--+-" in target.read_bytes()
    assert b"cell----" in target.read_bytes()


@given(
    spatial,
    st.tuples(*[st.fractions(-2, 2, max_denominator=3)] * 3),
    st.fractions("1/3", 3, max_denominator=5),
    st.randoms(use_true_random=False),
)
def test_chosen_cube_shows_the_cells_that_meet_it(planes, centre, radius, samples):
    cells = cut_cells(planes, "cube", centre, radius)
    stage = Stage(cells, DIRECTION)
    assert wrong_pairs(stage, stage.facets, samples) == []
    seen = {cell.signs for cell in cells.cells}
    for _ in range(20):
        shift = [Fraction(samples.randint(-99, 99), 100) * radius for _ in range(3)]
        signs = planes.signs_at([c + x for c, x in zip(centre, shift, strict=True)])
        assert 0 in signs or signs in seen
    assert seen <= {face.signs for face in planes.regions()}


def test_far_vertices_can_be_left_out():
    """Two of the planes meet x = 0 in lines that cross at y = 1000; near the origin they do not."""
    planes = Arrangement([[1, 0, 0], [0, 1, 1000], [0, 1, -1000]], [0, 1000, 1000])
    everything = painted(draw_planes(planes, body="cube"), "facet-")
    near = painted(draw_planes(planes, body="cube", centre=(0, 0, 0), radius=2), "facet-")
    assert len(everything) == f_vector(planes)[2] == 12
    assert len(near) == 3 + 2 * 2


SIMPLEX = Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], [0, 0, 0, 1])
PLANES = {
    "simplex": SIMPLEX,
    "irrational": IRRATIONAL,
    "parallel": read_arrangement("parallel-planes-affine"),
    "central": read_arrangement("cube-diagonals"),
    "coincident": read_arrangement("coincident-planes"),
    "one": Arrangement([[1, 2, 3]], [4]),
    "none": Arrangement([], dimension=3),
    "lines": read_arrangement("generic-lines-affine"),
}


def data_of(page: str) -> dict[str, Any]:
    found = re.search(r'id="data">(.*?)</script>', page)
    assert found is not None
    data: dict[str, Any] = json.loads(found[1])
    return data


@pytest.mark.parametrize("name", PLANES)
def test_the_page_has_every_cell_with_its_signs(name):
    planes = PLANES[name]
    data = data_of(cells_page(planes))
    signs = ["".join("+" if s > 0 else "−" for s in face.signs) for face in planes.regions()]
    assert sorted(piece["name"] for piece in data["pieces"]) == sorted(s or "all" for s in signs)
    pieces = [{face["piece"] for face in node["faces"]} for node in data["nodes"]]
    assert sorted(k for found in pieces for k in found) == list(range(len(signs)))


@given(
    arrangements(dimensions=(3, 3), planes=(1, 4)),
    st.floats(1, 3),
    st.tuples(*[st.integers(-5, 5)] * 3).filter(any),
)  # fmt: skip
def test_no_cell_apart_is_painted_over_one_that_is_nearer(planes, explode, direction):
    """Two cells in order are separated by a plane with the viewer on the side of the later one."""
    data = data_of(cells_page(planes, explode=explode))
    solids = []
    todo = [(0, False)]
    while todo:
        k, ready = todo.pop()
        if k < 0:
            continue
        node = data["nodes"][k]
        if ready:
            solids += [node["faces"]] if node["faces"] else []
            continue
        ahead = np.dot(node["row"], direction) > 0
        near, far = ("front", "back") if ahead else ("back", "front")
        todo += [(node[near], False), (k, True), (node[far], False)]
    moved = [
        np.array([np.array(p) + (explode - 1) * np.array(face["middle"])
                  for face in faces for p in face["at"]])
        for faces in solids
    ]  # fmt: skip
    ways = [np.array(plane[:3]) for plane in planes.integer_planes]
    for i, behind in enumerate(moved):
        for before in moved[i + 1 :]:
            assert any(
                (side * before @ way).min() >= (side * behind @ way).max() - 1e-3
                for way in ways
                for side in (1, -1)
                if side * way @ np.array(direction) >= 0
            )


@pytest.mark.slow
@pytest.mark.parametrize("name", ["simplex", "one", "none"])
def test_the_page_opens_turns_and_tells(name, browser, tmp_path):
    browser.show(cells_page(PLANES[name]), tmp_path)
    assert browser.count("#solid .face") > 0
    browser.run("document.getElementById('solid').dispatchEvent("
                "new KeyboardEvent('keydown', {key: 'n'}))")  # fmt: skip
    browser.settled()
    chosen = browser.text("chosen-title")
    assert chosen == data_of(cells_page(PLANES[name]))["pieces"][0]["name"]
    assert browser.count("#solid .chosen") > 0
    assert browser.messages() == []


def test_what_is_in_front_moves_with_the_pointer(browser, tmp_path):
    """Downwards as upwards: the nearest corner goes where the drag goes."""
    browser.show(cells_page(PLANES["one"]), tmp_path)
    box = browser.middle("#solid")
    # What is painted last is nearest.
    place = (
        "const r = [...document.querySelectorAll('#solid .face')].at(-1).getBoundingClientRect();"
        "return r.y + r.height / 2"
    )
    for way in (15, -15):
        before = browser.run(place)
        browser.drag(box, (box[0], box[1] + way))
        assert (browser.run(place) - before) * way > 0


BRAID = read_arrangement("braid-a3-in-r4")
#: An affine graphic arrangement of rank 2 in R^3, and a restriction of rank 3 in R^5.
GRAPHIC = Arrangement([[1, -1, 0], [0, 1, -1], [1, 0, -1]], [0, 1, 0])
RESTRICTION = Arrangement([[1, 2, 0, 0, 1], [0, 0, 1, 0, 0], [0, 0, 0, 1, 3]], [1, 0, 2])


def texts(figure: Any) -> list[str]:
    return [text.get_text() for text in figure.axes[0].texts]


def test_planes_in_their_own_space_have_no_caption():
    assert not any("arrangement" in text for text in texts(draw_sphere(read_arrangement("pencil"))))
    assert "arrangement in R¹, times a line" in texts(draw_lines(Arrangement([[1], [2]], [0, 1])))


@given(
    st.lists(st.tuples(*[st.integers(-3, 3)] * 2), min_size=1, max_size=5),
    st.tuples(*[st.tuples(*[st.integers(-2, 2)] * 4)] * 2),
    st.lists(st.integers(-2, 2), min_size=5, max_size=5),
)
def test_signs_and_faces_preserved_in_other_space(coefficients, basis, offsets):
    normals = [[a * x + b * y for x, y in zip(*basis, strict=True)] for a, b in coefficients]
    normals = [normal for normal in normals if any(normal)]
    planes = Arrangement(normals, offsets[: len(normals)], dimension=4)
    for dimension in {2, 3}:
        moved = in_space(planes, dimension)
        assert (moved.dimension, moved.rank) == (dimension, planes.rank)
        assert moved.distinct == planes.distinct
        assert {f.signs for f in moved.regions()} == {f.signs for f in planes.regions()}
        for before, after in zip(_cosines(planes), _cosines(moved), strict=True):
            assert math.isclose(before, after, abs_tol=2e-3)


def _cosines(planes: Arrangement) -> list[float]:
    units = np.array([plane[:-1] for plane in planes.integer_planes], dtype=float)
    units = units.reshape(len(planes), planes.dimension)
    units /= np.linalg.norm(units, axis=1, keepdims=True)
    return [float(x) for x in (units @ units.T).ravel()]


def test_single_planes_of_pages_and_models_have_colours():
    planes = Arrangement([[1, 0, 0], [2, 0, 0], [0, 1, 0], [0, 0, 1]], names=["", "", "ell", ""])
    plain, page = cells_page(planes), cells_page(planes, colours="2=#123456,ell=#654321")
    data = data_of(page)
    fills = {face["fill"] for node in data["nodes"] for face in node["faces"]}
    assert {"#123456", "#654321"} < fills
    assert "#123456" not in plain
    assert {fill for fill, _ in data["legend"]} == fills
    models = [cells_model(planes, ".glb", colours=x) for x in (None, "ell=#654321", "3=#654321")]
    assert models[0] != models[1] == models[2]
    with pytest.raises(InputError, match="keep one of them"):
        cells_model(planes, ".glb", colour="sides", colours="1=red")


@pytest.mark.parametrize("planes", [BRAID, GRAPHIC, RESTRICTION])
def test_models_and_pages_are_made_of_the_essentialisation(planes):
    moved = in_space(planes, 3)
    assert f_vector(moved)[-1] == f_vector(planes)[-1]
    assert cells_model(planes, ".stl", body="cube") == cells_model(moved, ".stl", body="cube")
    if planes.is_central:
        assert "essentialisation of an arrangement in R\\u2074" in arrangement_page(planes)


@pytest.mark.slow
@pytest.mark.parametrize("name", PLANAR)
def test_by_default_there_is_what_suits_the_planes(name, tmp_path):
    planes = read_arrangement(name)
    found = DRAWINGS.of(planes)
    view = next(iter(found.views))
    expected = "lines" if planes.dimension == 2 else "sphere" if planes.is_central else "cells"
    assert view == expected
    assert write_drawing(planes, tmp_path / "a.svg") == {"view": view}
    assert next(iter(found.models.values())).shows(planes)
    assert next(iter(found.pages.values())).shows(planes)


CASES = {
    "A3": read_arrangement("braid-a3"),
    "pencil": read_arrangement("pencil"),
    "coincident": read_arrangement("paper-four-contacts"),
    "affine": AFFINE,
    "no planes": Arrangement([], dimension=3),
}
none_or_more = arrangements(dimensions=(3, 3), planes=(0, 5))
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


@given(none_or_more)
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


def test_ball_is_convex_with_corners_on_the_sphere():
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


@given(none_or_more, st.sampled_from(["ball", "cube"]))
def test_the_body_contains_every_lowest_face(planes, kind):
    body = body_around(planes, kind)
    cells = cut_cells(planes, kind)
    assert len(cells.cells) == region_count(planes)
    if planes.rank == 3:
        for face in planes.faces(0):
            apart = [x - c for x, c in zip(face.witness, body.centre, strict=True)]
            assert sum(x * x for x in apart) * 16 <= 9 * body.radius**2


def loaded(path: FilePath) -> Any:
    return trimesh.load(path, force="mesh")


def shells(path: FilePath) -> list[Any]:
    return list(loaded(path).split(only_watertight=False))


@pytest.mark.slow
@pytest.mark.parametrize("body", ["ball", "cube"])
@pytest.mark.parametrize("name", CASES)
def test_stl_shells_are_closed_and_fill_the_body(name, body, tmp_path):
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


def glb(path: FilePath) -> dict[str, Any]:
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


def test_glb_and_stl_hold_the_same_solids(tmp_path):
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


@pytest.mark.parametrize("model", ["cells", "dual"])
def test_stl_and_obj_say_that_they_are_in_millimetres(model, tmp_path, run):
    for suffix in (".stl", ".obj"):
        path = tmp_path / f"a{suffix}"
        run("draw braid-a3 -o {} --model {} --size 25.5", path, model)
        assert b"unit: millimetre" in path.read_bytes()[:80]
    header = (tmp_path / "a.stl").read_bytes()[:80]
    assert not header.startswith(b"solid")


def test_dual_faces_coloured_by_number_of_corners(tmp_path):
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


def test_merged_points_leave_a_closed_surface():
    corner = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    split = np.concatenate([corner, [[1e-12, 0, 0]]])
    faces = ((0, 2, 1), (4, 1, 3), (1, 2, 3), (2, 0, 3), (0, 1, 4), (0, 4, 3))
    text = model_bytes([ClosedSurface("a", split, faces, ("#ffffff",) * 6)], ".obj", "t").decode()
    assert text.count("\nv ") == 4
    assert text.count("\nf ") == 4
    flat = corner * [1, 1, 1e-12]
    with pytest.raises(ArrangementError, match="too thin"):
        model_bytes([ClosedSurface("a", flat, TETRAHEDRON, ("#ffffff",) * 4)], ".stl", "t")
