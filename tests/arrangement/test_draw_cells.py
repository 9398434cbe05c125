"""Cells apart, and views of planes of any space: what is shown, what is drawn by default."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from arrangement import Arrangement
from arrangement.cli import main
from arrangement.counts import f_vector
from arrangement.drawing.scene.layout import laid_out
from arrangement.drawing.scene.scene import Label, Scene
from arrangement.library.files.table import read_arrangement
from arrangement.pictures import (
    arrangement_page,
    cells_page,
    draw_lines,
    draw_sphere,
    write_drawing,
)
from arrangement.pictures.parts.essential import SPACES, fits, in_space
from arrangement.pictures.space.cells import cells_model
from arrangement.pictures.views import DRAWINGS, drawings_of
from tests.browser import Browser
from tests.instances import PLANAR

from .strategies import arrangements

SIMPLEX = Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], [0, 0, 0, 1])
PLANES = {
    "simplex": SIMPLEX,
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
def test_the_page_has_every_cell_with_its_signs(name: str) -> None:
    planes = PLANES[name]
    data = data_of(cells_page(planes))
    signs = ["".join("+" if s > 0 else "−" for s in face.signs) for face in planes.regions()]
    assert sorted(piece["name"] for piece in data["pieces"]) == sorted(s or "all" for s in signs)
    pieces = [{face["piece"] for face in node["faces"]} for node in data["nodes"]]
    assert sorted(k for found in pieces for k in found) == list(range(len(signs)))


@settings(max_examples=25, deadline=None)
@given(
    arrangements(dimensions=(3, 3), planes=(1, 4)),
    st.floats(1, 3),
    st.tuples(*[st.integers(-5, 5)] * 3).filter(any),
)  # fmt: skip
def test_no_cell_apart_is_painted_over_one_that_is_nearer(
    planes: Arrangement, explode: float, direction: tuple[int, ...]
) -> None:
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


@pytest.mark.campaign
@pytest.mark.parametrize("name", ["simplex", "one", "none"])
def test_the_page_opens_turns_and_tells(name: str, browser: Browser, tmp_path: Path) -> None:
    (tmp_path / "a.html").write_text(cells_page(PLANES[name]), encoding="utf-8")
    browser.open(tmp_path / "a.html")
    browser.settled()
    drawn = "return document.querySelectorAll('#solid .face').length"
    assert browser.run(drawn) > 0
    browser.run("document.getElementById('solid').dispatchEvent("
                "new KeyboardEvent('keydown', {key: 'n'}))")  # fmt: skip
    browser.settled()
    chosen = browser.run("return document.getElementById('chosen-title').textContent")
    assert chosen == data_of(cells_page(PLANES[name]))["pieces"][0]["name"]
    assert browser.run("return document.querySelectorAll('#solid .chosen').length") > 0
    assert browser.messages() == []


def test_what_is_in_front_moves_with_the_pointer(browser: Browser, tmp_path: Path) -> None:
    """Downwards as upwards: the nearest corner goes where the drag goes."""
    page = cells_page(PLANES["one"])
    (tmp_path / "a.html").write_text(page, encoding="utf-8")
    browser.open(tmp_path / "a.html")
    browser.settled()
    box = browser.run(
        "const r = document.getElementById('solid').getBoundingClientRect();"
        "return [r.x + r.width / 2, r.y + r.height / 2]"
    )
    # What is painted last is nearest.
    place = (
        "const r = [...document.querySelectorAll('#solid .face')].at(-1).getBoundingClientRect();"
        "return r.y + r.height / 2"
    )
    for way in (15, -15):
        before = browser.run(place)
        browser.drag(tuple(box), (box[0], box[1] + way))
        assert (browser.run(place) - before) * way > 0


def test_affine_planes_have_a_page_by_default(tmp_path: Path) -> None:
    assert main(["draw", "parallel-planes-affine", "-o", str(tmp_path / "a.html")]) == 0
    page = (tmp_path / "a.html").read_text(encoding="utf-8")
    assert data_of(page)["counts"].startswith("6 cells in a cube with centre (0, 0, 1/2)")


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
