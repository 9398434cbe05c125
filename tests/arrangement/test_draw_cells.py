"""Cells of planes apart: a picture with every cell, and a page to turn."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from arrangement import Arrangement, InputError
from arrangement.cli import main
from arrangement.drawing.scene.scene import Scene
from arrangement.library.files.table import read_arrangement
from arrangement.pictures import cells_page, draw_cells
from arrangement.pictures.space.cells import MOST
from tests.browser import Browser

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


@pytest.mark.campaign
@pytest.mark.parametrize("name", PLANES)
@pytest.mark.parametrize("body", ["cube", "ball"])
def test_some_face_of_every_cell_is_painted(name: str, body: str) -> None:
    scene: Scene = draw_cells.scene(PLANES[name], body=body, labels="none")
    cells = {item.name for item in scene.items if item.name.startswith("cell-")}
    assert len(cells) == len(PLANES[name].regions())


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
    st.lists(
        st.tuples(*[st.integers(-2, 2)] * 4).filter(lambda plane: any(plane[:3])),
        min_size=1, max_size=4,
    ),
    st.floats(1, 3),
    st.tuples(*[st.integers(-5, 5)] * 3).filter(any),
)  # fmt: skip
def test_no_cell_apart_is_painted_over_one_that_is_nearer(
    rows: list[tuple[int, ...]], explode: float, direction: tuple[int, ...]
) -> None:
    """Two cells in order are separated by a plane with the viewer on the side of the later one."""
    planes = Arrangement([row[:3] for row in rows], [row[3] for row in rows])
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


@pytest.mark.parametrize("draw", [draw_cells, cells_page])
def test_what_cannot_be_shown_is_refused(draw: Callable[..., Any]) -> None:
    with pytest.raises(InputError, match="factor from 1 to 3"):
        draw(SIMPLEX, explode=0.5)
    with pytest.raises(InputError, match=f"at most {MOST}"):
        draw(Arrangement([[1, k, k * k] for k in range(15)], [k**3 for k in range(15)]))
    with pytest.raises(InputError, match="lattice"):
        draw(Arrangement(np.eye(4, dtype=int).tolist()))
