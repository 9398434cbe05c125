"""Pictures: what is drawn is what is counted, files repeat, nothing half-written."""

from __future__ import annotations

import math
import re
import sys
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.image import imread

from arrangement import Arrangement, MissingExtraError
from arrangement.cli import main
from arrangement.drawing.colours import DrawnRegion, colouring
from arrangement.drawing.figure import figure
from arrangement.drawing.output import picture_bytes
from arrangement.drawing.scene.scene import Scene
from arrangement.library.files.table import read_arrangement
from arrangement.pictures import draw_sphere, save_figure, write_drawing
from tests.drawn import paths

NAMES = ["four-generic-planes", "braid-a3", "reflection-b3", "pencil", "coincident-planes"]
VIEW = (5, 3, 4)


def test_sign_vectors_that_fit_are_written_once() -> None:
    axes = draw_sphere(read_arrangement("coordinate-planes"), direction=(4, 5, 3)).axes[0]
    written = [text.get_text().replace("\u200a", "") for text in axes.texts]
    texts = [text for text in written if set(text) <= set("+−\n")]
    assert "+++" in texts
    assert len(texts) == len(set(texts))


def test_model_suffix_exports_the_dual(tmp_path: Path) -> None:
    assert main(["draw", "braid-a3", "-o", str(tmp_path / "a.stl"), "--json"]) == 0
    assert (tmp_path / "a.stl").stat().st_size > 84


def test_colouring_by_a_function_of_the_region() -> None:
    planes = read_arrangement("coordinate-planes")
    figure = draw_sphere(planes, colour=lambda region: "red" if region.signs[0] > 0 else "blue")
    fills = {x.style["fc"] for x in paths(figure) if x.role == "region"}
    assert fills == {"red", "blue"}


@pytest.mark.parametrize("library", ["matplotlib", "shapely"])
def test_missing_library_names_the_extra(
    library: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setitem(sys.modules, library, None)
    with pytest.raises(MissingExtraError, match=r"slipstates\[figures\]"):
        write_drawing(read_arrangement("pencil"), tmp_path / "a.svg")


def test_the_colouring_by_minus_signs_has_a_legend() -> None:
    axes = draw_sphere(read_arrangement("coordinate-planes"), colour="signs").axes[0]
    written = [text.get_text() for text in axes.texts]
    assert {"0", "1", "2", "3 minus signs"} <= set(written)


@pytest.mark.parametrize("antipodes", [None, "same", "opposite"])
@pytest.mark.parametrize("name", [*NAMES, "coordinate-planes", "nine-generic-planes"])
def test_neighbours_differ_and_opposite_regions_are_as_asked(name: str, antipodes: str) -> None:
    planes = read_arrangement(name)
    regions = [DrawnRegion(face.signs, 0) for face in planes.regions()]
    pairs = neighbours(planes)
    found = colouring("parity", antipodes, regions, pairs, planes.distinct)
    fills = {region.signs: found.paint(region) for region in regions}
    assert pairs
    assert all(fills[regions[a].signs] != fills[regions[b].signs] for a, b in pairs)
    alike = {fills[signs] == fills[tuple(-s for s in signs)] for signs in fills}
    natural = "opposite" if len(planes.distinct) % 2 else "same"
    assert alike == {(antipodes or natural) == "same"}
    if antipodes in (None, natural):
        assert len(set(fills.values())) == 2
    elif antipodes == "opposite":
        assert len(set(fills.values())) == 4


def neighbours(planes: Arrangement) -> list[tuple[int, int]]:
    """Return the pairs of regions that differ on one class of planes, from sign vectors alone."""
    signs = [face.signs for face in planes.regions()]
    first = [members[0] for members in planes.distinct]
    return [
        (a, b)
        for a, b in combinations(range(len(signs)), 2)
        if sum(signs[a][k] != signs[b][k] for k in first) == 1
    ]


def test_sides_colour_only_where_they_tell_neighbours_apart() -> None:
    def legend(name: str) -> set[str]:
        return {text.get_text() for text in draw_sphere(read_arrangement(name)).axes[0].texts}

    assert {"3 sides", "4 sides"} <= legend("cube-diagonals")
    assert "odd number of minus signs" in legend("five-generic-planes")


@pytest.mark.parametrize("name", ["braid-a3", "pencil", "four-generic-planes"])
def test_numbers_are_those_of_the_regions_and_the_table_explains_them(name: str) -> None:
    planes = read_arrangement(name)
    texts = [t.get_text() for t in draw_sphere(planes, labels="numbers").axes[0].texts]
    rows = [re.fullmatch(r"[\s\u2007]*(\d+) ([+\u2212\u200a]+)", text) for text in texts]
    table = {int(row[1]): row[2].replace("\u200a", "") for row in rows if row}
    regions = planes.regions()
    for number, signs in table.items():
        assert signs == "".join("+" if s > 0 else "\u2212" for s in regions[number - 1].signs)
    written = {int(text) for text in texts if text.isdigit() and int(text) > len(planes)}
    assert written <= set(table)
    assert len(table) > len(regions) / 2


def test_labels_can_be_left_out_and_bad_ones_are_refused() -> None:
    planes = read_arrangement("braid-a3")
    texts = [t.get_text() for t in draw_sphere(planes, labels="none", colour="none").axes[0].texts]
    assert sorted(texts) == ["1", "2", "3", "4", "5", "6"]


def test_motions_have_axes_and_other_spaces_when_asked() -> None:
    def named(name: str, **options: Any) -> set[str]:
        figure = draw_sphere(read_arrangement(name), **options)
        return {t.get_text() for t in figure.axes[0].texts} & {"x", "y", "z", "r"}

    assert named("paper-three-contacts") == {"x", "y", "r"}
    assert named("paper-three-contacts", axes="none") == set()
    assert named("braid-a3") == set()
    assert named("braid-a3", axes="x,y,z") == {"x", "y", "z"}


@pytest.mark.parametrize("name", ["braid-a3", "four-generic-planes", "coincident-planes"])
def test_arrows_point_to_the_positive_side_of_each_plane(name: str) -> None:
    """Both ends of an arrow, taken back to the sphere; a leader line is no arrow."""
    planes = read_arrangement(name)
    scene = draw_sphere.scene(planes, direction=VIEW, sides=True, coordinates="given")
    ball = next(item for item in scene.items if item.role == "ball")
    ahead = np.array(VIEW) / np.linalg.norm(VIEW)
    right = np.array([-VIEW[1], VIEW[0], 0.0]) / np.hypot(*VIEW[:2])
    frame = np.array([right, np.cross(ahead, right), ahead])
    heads = [i for i in scene.items if i.name.startswith("side") and i.kind == "polygon"]
    assert len(heads) == len(planes.distinct)
    for head in heads:
        u = (head.points[3] - np.array(ball.centre)) / ball.radius
        tip = np.array([*u, np.sqrt(1 - u @ u)]) @ frame
        label = int(head.name.split("-")[1])
        assert np.array(planes.normals[planes.distinct[label][0]], dtype=float) @ tip > 0


def test_a_ball_is_lit_at_its_focus_and_darkest_at_the_rim(tmp_path: Path) -> None:
    scene = Scene(40, 40)
    centre, radius = scene.width / 2, 50.0
    scene.ball((centre, centre), radius, "#ffffff", "#404040", focus=(-0.4, 0.3))
    save_figure(tmp_path / "a.png", lambda: figure(scene))
    shades = imread(tmp_path / "a.png")[..., 0]
    row, column = np.unravel_index(np.argmin(shades), shades.shape)
    pixels = len(shades) / scene.height
    out = math.hypot(column / pixels - centre, scene.height - row / pixels - centre)
    assert abs(out - radius) < 1
    at = (int((centre - 0.3 * radius) * pixels), int((centre - 0.4 * radius) * pixels))
    assert shades[at] > 0.99


@pytest.mark.parametrize("view", ["sphere", "dual", "lattice"])
def test_width_and_size_of_letters_hold(view: str, tmp_path: Path) -> None:
    """With letters twice as large the lines are twice as wide, on the same width of paper."""
    planes, found = read_arrangement("coordinate-planes"), []
    for size, width in (("7pt", "200mm"), (14, "20cm")):
        write_drawing(planes, tmp_path / "a.svg", view, width=width, font_size=size, text="text")
        text = (tmp_path / "a.svg").read_text(encoding="utf-8")
        paper = float(re.search(r'width="([\d.]+)pt"', text)[1])  # type: ignore[index]
        assert abs(paper - 200 * 72 / 25.4) < 0.01
        letters = {float(x) for x in re.findall(r"font(?:-size)?: ?[^;]*?([\d.]+)px", text)}
        lines = {float(x) for x in re.findall(r"stroke-width: ([\d.]+)", text)}
        found.append((max(letters), max(lines)))
    assert found[1] == pytest.approx([2 * x for x in found[0]])


def test_letters_of_an_svg_can_be_kept_as_text(tmp_path: Path) -> None:
    """Those with a halo too."""
    scene = Scene(40, 20)
    scene.text((40, 30), "halo", halo=(2, "white"))
    scene.text((40, 10), "plain")
    content = picture_bytes(".svg", lambda: figure(scene), letters=True).decode()
    assert re.findall(r"<text[^>]*>(\w+)</text>", content) == ["halo", "plain"]
    assert "<text" not in picture_bytes(".svg", lambda: figure(scene)).decode()
