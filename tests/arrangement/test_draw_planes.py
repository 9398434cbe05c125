"""Planes in a ball or cube: the order of painting is right, what is drawn is what is counted."""

from __future__ import annotations

import random
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from arrangement import Arrangement
from arrangement.cli import main
from arrangement.counts import f_vector
from arrangement.duals.cells import cut_cells
from arrangement.library.files.table import read_arrangement
from arrangement.pictures.space.exploded_cells import Facet, Stage, lifted_cells
from arrangement.pictures.space.planes import draw_planes
from tests.drawn import paths

from .strategies import arrangements

Point = tuple[Fraction, ...]
NAMES = ["braid-a3", "reflection-b3", "pencil", "coincident-planes", "parallel-planes-affine"]
#: Five affine planes in general position, with bounded regions.
AFFINE = Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1], [2, -1, 1]], [0, 0, 0, 1, "1/3"])
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


@pytest.mark.campaign
@settings(max_examples=30, deadline=None)
@given(
    spatial,
    st.tuples(*[st.integers(-3, 3)] * 3).filter(any),
    st.sampled_from(["ball", "cube"]),
    st.randoms(use_true_random=False),
)
def test_no_facet_is_painted_after_one_in_front_of_it(
    planes: Arrangement, direction: tuple[int, int, int], body: str, samples: random.Random
) -> None:
    stage = Stage(cut_cells(planes, body), direction)
    assert wrong_pairs(stage, stage.facets, samples) == []


@pytest.mark.parametrize("name", ["braid-a3", "reflection-b3"])
def test_the_check_of_the_order_finds_a_wrong_order(name: str) -> None:
    stage = Stage(cut_cells(read_arrangement(name), "cube"), DIRECTION)
    assert wrong_pairs(stage, stage.facets, random.Random(1)) == []
    assert wrong_pairs(stage, stage.facets[::-1], random.Random(1))


@settings(max_examples=20, deadline=None)
@given(spatial, st.sampled_from(["ball", "cube"]))
def test_every_facet_and_every_region_meets_the_body(planes: Arrangement, body: str) -> None:
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
def test_facets_of_a_plane_fill_its_disc_in_the_ball(planes: Arrangement) -> None:
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


@pytest.mark.parametrize("body", ["ball", "cube"])
@pytest.mark.parametrize("name", NAMES)
def test_the_picture_has_every_facet_once_in_order(name: str, body: str) -> None:
    planes = read_arrangement(name)
    drawn = painted(draw_planes(planes, body=body), "facet-")
    assert len(drawn) == f_vector(planes)[2]
    numbers = [int(gid.split("-")[1]) for gid in sorted(drawn, key=lambda gid: drawn[gid])]
    assert numbers == list(range(len(drawn)))


@pytest.mark.parametrize(
    ("planes", "numbers"),
    [(read_arrangement("braid-a3"), [0, 5, 14, 23]), (AFFINE, range(0, 24, 3))],
    ids=["A3", "affine"],
)
@pytest.mark.parametrize("direction", [(5, 3, 4), (-2, 5, 1), (1, -6, -3)])
def test_lifted_cells_are_painted_between_what_hides_them_and_what_they_hide(
    planes: Arrangement, numbers: Sequence[int], direction: tuple[int, int, int]
) -> None:
    """Lines of sight through the middles of facets and of lifted cells meet the rest in order."""
    chosen = [planes.regions()[number].signs for number in numbers]
    texts = ["".join("+" if s > 0 else "-" for s in signs) for signs in chosen]
    figure = draw_planes(planes, body="cube", direction=direction, lift=texts)
    stage = Stage(cut_cells(planes, "cube"), direction)
    lifted = lifted_cells(stage, chosen)
    when = painted(figure, "cell-")
    facets = {int(g.split("-")[1]): z for g, z in painted(figure, "facet-").items()}
    things: list[tuple[float, Any, Any]] = [
        (facets[i], stage.points[list(facet.corners)].mean(axis=0), None)
        for i, facet in enumerate(stage.facets)
    ]
    for item in lifted:
        name = "cell-" + "".join("+" if s > 0 else "-" for s in item.cell.signs)
        things.append((when[name], item.corners.mean(axis=0), item))
    met = 0
    for z, point, own in things:
        for solid in lifted:
            name = "cell-" + "".join("+" if s > 0 else "-" for s in solid.cell.signs)
            interval = sight_through(solid, point)
            if solid is own or interval is None:
                continue
            low, high = interval
            assert not low < point[2] < high
            met += 1
            assert (z > when[name]) == (point[2] > high)
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


def test_numbers_name_the_planes_and_coincident_ones_share_a_place() -> None:
    axes = draw_planes(read_arrangement("paper-four-contacts"), body="cube", axes="none").axes[0]
    assert sorted(text.get_text() for text in axes.texts) == ["1,2", "3,4"]


def test_the_command_takes_signs_that_begin_with_a_minus(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target = tmp_path / "a.svg"
    arguments = ["draw", "coordinate-planes", "-o", str(target), "--view", "planes"]
    more = ["--lift=-+-", "--lift=---", "--body", "cube", "--direction", "-1/2", "3", "0.7"]
    assert main([*arguments, *more, "--width", "120", "--json"]) == 0
    assert '"view": "planes"' in capsys.readouterr().out
    assert b"cell--+-" in target.read_bytes()
    assert b"cell----" in target.read_bytes()


@settings(max_examples=20, deadline=None)
@given(
    spatial,
    st.tuples(*[st.fractions(-2, 2, max_denominator=3)] * 3),
    st.fractions("1/3", 3, max_denominator=5),
    st.randoms(use_true_random=False),
)
def test_a_chosen_cube_shows_the_cells_that_meet_it_and_is_filled(
    planes: Arrangement, centre: Point, radius: Fraction, samples: random.Random
) -> None:
    cells = cut_cells(planes, "cube", centre, radius)
    stage = Stage(cells, DIRECTION)
    assert wrong_pairs(stage, stage.facets, samples) == []
    seen = {cell.signs for cell in cells.cells}
    for _ in range(20):
        shift = [Fraction(samples.randint(-99, 99), 100) * radius for _ in range(3)]
        signs = planes.signs_at([c + x for c, x in zip(centre, shift, strict=True)])
        assert 0 in signs or signs in seen
    assert seen <= {face.signs for face in planes.regions()}


def test_far_vertices_can_be_left_out() -> None:
    """Two of the planes meet x = 0 in lines that cross at y = 1000; near the origin they do not."""
    planes = Arrangement([[1, 0, 0], [0, 1, 1000], [0, 1, -1000]], [0, 1000, 1000])
    everything = painted(draw_planes(planes, body="cube"), "facet-")
    near = painted(draw_planes(planes, body="cube", centre=(0, 0, 0), radius=2), "facet-")
    assert len(everything) == f_vector(planes)[2] == 12
    assert len(near) == 3 + 2 * 2
