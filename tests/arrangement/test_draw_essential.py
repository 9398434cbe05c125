"""Views of planes of any space: the essentialisation, what is refused, what is drawn by default."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from arrangement import Arrangement, InputError
from arrangement.cli import main
from arrangement.counts import f_vector
from arrangement.drawing.scene.items import Label
from arrangement.drawing.scene.layout import laid_out
from arrangement.drawing.scene.scene import Scene
from arrangement.library.files.table import read_arrangement
from arrangement.pictures import arrangement_page, draw_lines, draw_sphere, write_drawing
from arrangement.pictures.duals.models import cells_model
from arrangement.pictures.essential import SPACES, fits, in_space
from arrangement.pictures.views import DRAWINGS, drawings_of
from tests.instances import PLANAR

BRAID = read_arrangement("braid-a3-in-r4")
#: An affine graphic arrangement of rank 2 in R^3, and a restriction of rank 3 in R^5.
GRAPHIC = Arrangement([[1, -1, 0], [0, 1, -1], [1, 0, -1]], [0, 1, 0])
RESTRICTION = Arrangement([[1, 2, 0, 0, 1], [0, 0, 1, 0, 0], [0, 0, 0, 1, 3]], [1, 0, 2])


def texts(figure: Any) -> list[str]:
    return [text.get_text() for text in figure.axes[0].texts]


@pytest.mark.campaign
@pytest.mark.parametrize("view", [*SPACES, "lattice"])
def test_braids_in_four_dimensions_are_drawn_and_the_caption_says_how(
    view: str, tmp_path: Path
) -> None:
    command = ["draw", "braid-a3-in-r4", "--view", view, "-o", str(tmp_path / "a.svg")]
    assert main(command) == (2 if view == "lines" else 0)
    module, _, name = DRAWINGS.views[view].partition(":")
    if view not in ("lines", "lattice"):
        draw = getattr(__import__(f"arrangement.pictures.{module}", fromlist=[name]), name)
        scene = laid_out(draw.scene(BRAID))
        assert isinstance(scene, Scene)
        *_, last = (item.text for item in scene.items if isinstance(item, Label))
        assert last == "essentialisation of an arrangement in R⁴"
        assert all(label.place[1] > 0 for label in scene.items if isinstance(label, Label))


def test_planes_in_their_own_space_have_no_caption() -> None:
    assert not any("arrangement" in text for text in texts(draw_sphere(read_arrangement("pencil"))))
    assert "arrangement in R¹, times a line" in texts(draw_lines(Arrangement([[1], [2]], [0, 1])))


@settings(max_examples=30, deadline=None)
@given(
    st.lists(st.tuples(*[st.integers(-3, 3)] * 2), min_size=1, max_size=5),
    st.tuples(*[st.tuples(*[st.integers(-2, 2)] * 4)] * 2),
    st.lists(st.integers(-2, 2), min_size=5, max_size=5),
)
def test_signs_faces_and_nearly_angles_are_those_in_the_other_space(
    coefficients: list[tuple[int, int]],
    basis: tuple[tuple[int, ...], tuple[int, ...]],
    offsets: list[int],
) -> None:
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


@pytest.mark.parametrize("planes", [BRAID, GRAPHIC, RESTRICTION])
def test_models_and_pages_are_made_of_the_essentialisation(planes: Arrangement) -> None:
    moved = in_space(planes, 3)
    assert f_vector(moved)[-1] == f_vector(planes)[-1]
    assert cells_model(planes, ".stl", body="cube") == cells_model(moved, ".stl", body="cube")
    if planes.is_central:
        assert "essentialisation of an arrangement in R\\u2074" in arrangement_page(planes)


@pytest.mark.parametrize(
    ("planes", "view", "others"),
    [
        ("shi-a2-affine", "sphere", "planes, cells, lines, lattice"),
        ("parallel-planes-affine", "dual", "planes, cells, lines, lattice"),
        ("braid-a3", "lines", "sphere, planes, cells, stereographic, gnomonic, dual, graph, latt"),
    ],
)
def test_a_refusal_names_the_views_that_there_are(planes: str, view: str, others: str) -> None:
    with pytest.raises(InputError, match=others):
        write_drawing(read_arrangement(planes), "never.svg", view)
    assert not Path("never.svg").exists()


def test_rank_four_has_its_lattice_only() -> None:
    planes = Arrangement(np.eye(4, dtype=int).tolist())
    assert [name for name in DRAWINGS.views if fits(name, planes)] == ["lattice"]
    assert next(iter(drawings_of(planes).views)) == "lattice"


@pytest.mark.campaign
@pytest.mark.parametrize("name", PLANAR)
def test_by_default_there_is_what_suits_the_planes(name: str, tmp_path: Path) -> None:
    planes = read_arrangement(name)
    found = drawings_of(planes)
    view = next(iter(found.views))
    expected = "lines" if planes.dimension == 2 else "sphere" if planes.is_central else "cells"
    assert view == expected
    assert write_drawing(planes, tmp_path / "a.svg") == {"view": view}
    assert fits(next(iter(found.models)), planes)
    assert fits(next(iter(found.pages)), planes)
