"""Pictures: what is drawn is what is counted, files repeat, nothing half-written."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import numpy as np
import pytest
from matplotlib.image import imread

from arrangement import Arrangement, InputError, MissingExtraError
from arrangement.cli import main
from arrangement.counts import f_vector
from arrangement.draw import draw_sphere, save_figure, write_drawing
from arrangement.draw.figure import figure
from arrangement.draw.scene import Scene
from arrangement.io.arrangements import read_arrangement

NAMES = ["four-generic-planes", "braid-a3", "reflection-b3", "pencil", "coincident-planes"]
VIEW = (5, 3, 4)


@pytest.mark.parametrize("name", NAMES)
def test_elements_drawn_are_those_counted_with_the_limb(name: str) -> None:
    """The limb is one more plane; half of all regions face the viewer (Zaslavsky counts them)."""
    planes = read_arrangement(name)
    figure = draw_sphere(planes, direction=VIEW)
    names = [patch.get_gid() or "" for patch in figure.axes[0].patches]
    kinds = {kind: sum(x.startswith(kind) for x in names) for kind in ("region", "front", "back")}
    _, _, arcs, regions = f_vector(Arrangement([*planes.normals, VIEW]))
    limb = sum(x.startswith("limb") for x in names)
    assert kinds["region"] == regions // 2
    assert kinds["front"] == kinds["back"]
    assert kinds["front"] + kinds["back"] + limb == arcs


@pytest.mark.parametrize("suffix", [".svg", ".pdf", ".png"])
def test_pictures_repeat_byte_for_byte(suffix: str, tmp_path: Path) -> None:
    planes = read_arrangement("four-generic-planes")
    for name in "ab":
        write_drawing(planes, tmp_path / f"{name}{suffix}")
    assert (tmp_path / f"a{suffix}").read_bytes() == (tmp_path / f"b{suffix}").read_bytes()
    assert len(list(tmp_path.iterdir())) == 2


def test_sign_vectors_that_fit_are_written_once() -> None:
    axes = draw_sphere(read_arrangement("coordinate-planes"), direction=(4, 5, 3)).axes[0]
    written = [text.get_text().replace("\u200a", "") for text in axes.texts]
    texts = [text for text in written if set(text) <= set("+−\n")]
    assert "+++" in texts
    assert len(texts) == len(set(texts))


def test_bad_requests_write_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = str(tmp_path / "a.svg")
    assert main(["draw", "pencil", "-o", target, "--view", "shadow"]) == 2
    assert "known are sphere, planes" in capsys.readouterr().err
    assert main(["draw", "pencil", "-o", target, "--colour", "mood"]) == 2
    assert main(["draw", "parallel-planes-affine", "--view", "sphere", "-o", target]) == 2
    assert main(["draw", "pencil", "-o", str(tmp_path / "a.gif")]) == 2
    assert list(tmp_path.iterdir()) == []


def test_model_suffix_exports_the_dual(tmp_path: Path) -> None:
    assert main(["draw", "braid-a3", "-o", str(tmp_path / "a.stl"), "--json"]) == 0
    assert (tmp_path / "a.stl").stat().st_size > 84


def test_colouring_by_a_function_of_the_region() -> None:
    planes = read_arrangement("coordinate-planes")
    figure = draw_sphere(planes, colour=lambda region: "red" if region.signs[0] > 0 else "blue")
    fills = {patch.get_facecolor() for patch in figure.axes[0].patches if patch.get_fill()}
    assert fills == {(1.0, 0.0, 0.0, 1.0), (0.0, 0.0, 1.0, 1.0)}


def test_missing_library_names_the_extra(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(MissingExtraError, match=r"slipstates\[figures\]"):
        write_drawing(read_arrangement("pencil"), tmp_path / "a.svg")


def test_a_zero_direction_is_refused() -> None:
    with pytest.raises(InputError, match="not all 0"):
        draw_sphere(read_arrangement("pencil"), direction=(0, 0, 0))


def test_the_colouring_by_minus_signs_has_a_legend() -> None:
    axes = draw_sphere(read_arrangement("coordinate-planes"), colour="signs").axes[0]
    assert [text.get_text() for text in axes.texts][-4:] == ["0", "1", "2", "3 minus signs"]


def test_sign_vectors_keep_off_the_dashed_arcs_or_stand_on_a_halo() -> None:
    axes = draw_sphere(read_arrangement("braid-a3"), direction=VIEW).axes[0]
    figure = axes.figure
    figure.canvas.draw()
    dashes = [p for p in axes.patches if (p.get_gid() or "").startswith("back")]
    curves = [p.get_transform().transform_path(p.get_path()) for p in dashes]
    signs = [t for t in axes.texts if set(t.get_text()) <= set("+\u2212\n\u200a")]
    assert len(signs) > 8
    crossed = [
        text
        for text in signs
        if any(c.intersects_bbox(text.get_window_extent(), filled=False) for c in curves)
    ]
    assert 0 < len(crossed) < len(signs) / 2
    assert all(text.get_path_effects() for text in crossed)


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
