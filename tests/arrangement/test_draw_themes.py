"""Themes: one map of colours for the scenes of both packages."""

from __future__ import annotations

import importlib
from pathlib import Path as File
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st

from arrangement.cli import main
from arrangement.drawing.output import own_settings
from arrangement.drawing.scene.items import Ball, Label, Path
from arrangement.drawing.scene.scene import Scene
from arrangement.drawing.themes import _from_oklab, _oklab, themed
from arrangement.library.files.table import read_arrangement
from arrangement.pictures import DRAWINGS as OF_PLANES
from equilibrium.grasps.files import read_grasp
from equilibrium.pictures import DRAWINGS as OF_GRASPS

unit = st.floats(0, 1)


def scene_of(drawings: Any, package: str, view: str, subject: Any, **options: Any) -> Scene:
    module, _, function = drawings.views[view].partition(":")
    draw = getattr(importlib.import_module(f"{package}.pictures.{module}"), function)
    with own_settings():
        scene: Scene = draw.scene(subject, **options)
    return scene


def lightness(colour: Any) -> float:
    from matplotlib.colors import to_rgb

    return float(_oklab(to_rgb(colour))[0])


def test_in_print_wrenches_are_black_and_one_set_has_a_hatching() -> None:
    grasp = read_grasp("paper-three-contacts-preload-1")
    for view, wrench in (("grasp", (0, 1, 1)), ("slice", (0, 1, 0))):
        scene = scene_of(OF_GRASPS, "equilibrium", view, grasp, wrench=wrench)
        made = themed(scene, "mono").items
        if view == "grasp":
            fills = {x.name: x.style.get("fc") for x in made if x.name.startswith("wrench-")}
            assert fills["wrench-force"] == fills["wrench-torque-head"] == "#000000"
        else:
            sets = [x for x in made if "polygon" in x.name]
            assert sets
            assert all("hatch" in x.style and not x.style["lw"] for x in sets)


@given(st.tuples(unit, unit, unit))
def test_oklab_and_back(rgb: tuple[float, float, float]) -> None:
    light, a, b = _oklab(rgb).tolist()
    assert np.allclose(_from_oklab((light, a, b), 1.0)[:3], rgb, atol=1e-4)


def test_greys_have_no_hue_in_oklab_and_white_has_lightness_one() -> None:
    assert np.allclose(_oklab((1.0, 1.0, 1.0)), (1, 0, 0), atol=1e-4)
    assert np.allclose(_oklab((0.5, 0.5, 0.5))[1:], 0, atol=1e-4)


@pytest.mark.parametrize(
    ("drawings", "package", "view", "subject"),
    [
        (OF_PLANES, "arrangement", "sphere", read_arrangement("braid-a3")),
        (OF_PLANES, "arrangement", "dual", read_arrangement("cube-diagonals")),
        (OF_PLANES, "arrangement", "graph", read_arrangement("braid-a3")),
        (OF_PLANES, "arrangement", "lattice", read_arrangement("braid-a3")),
        (OF_GRASPS, "equilibrium", "resist", read_grasp("paper-three-contacts-preload-1")),
    ],
)
def test_dark_letters_are_light_and_mono_has_no_colour(
    drawings: Any, package: str, view: str, subject: Any
) -> None:
    scene = scene_of(drawings, package, view, subject)
    dark, mono = themed(scene, "dark"), themed(scene, "mono")
    assert themed(scene, "light") is scene
    assert len(mono.items) == len(scene.items) == len(dark.items) - 1
    plain = {id(i) for i in scene.items if isinstance(i, Label) and "plate" not in i.style}
    for old, new in zip(scene.items, dark.items[1:], strict=True):
        if id(old) in plain and lightness(old.style.get("color", "black")) < 0.4:
            assert lightness(new.style["color"]) > 0.6
    for item in mono.items:
        for key in ("fc", "ec", "color"):
            colour = item.style.get(key, "none")
            if not isinstance(item, Ball) and str(colour) != "none":
                assert abs(_oklab(_rgb(colour))[1:]).max() < 1e-2


def _rgb(colour: Any) -> tuple[float, ...]:
    from matplotlib.colors import to_rgb

    rgb: tuple[float, ...] = to_rgb(colour)
    return rgb


def test_mono_keeps_apart_what_colours_keep_apart() -> None:
    scene = scene_of(OF_PLANES, "arrangement", "sphere", read_arrangement("five-generic-planes"),
                     antipodes="same")  # fmt: skip
    mono = themed(scene, "mono")
    pairs = {
        (str(old.style["fc"]), (new.style["fc"], new.style.get("hatch", "")))
        for old, new in zip(scene.items, mono.items, strict=True)
        if isinstance(old, Path) and old.name.startswith("region")
    }
    assert len(pairs) == len({a for a, _ in pairs}) == len({b for _, b in pairs}) >= 4


@pytest.mark.campaign
@pytest.mark.parametrize("suffix", [".svg", ".tex", ".pdf"])
@pytest.mark.parametrize("theme", ["dark", "mono"])
def test_themed_pictures_repeat_byte_for_byte(theme: str, suffix: str, tmp_path: File) -> None:
    for name in "ab":
        target = str(tmp_path / f"{name}{suffix}")
        assert main(["draw", "braid-a3", "--theme", theme, "-o", target]) == 0
    assert (tmp_path / f"a{suffix}").read_bytes() == (tmp_path / f"b{suffix}").read_bytes()


def test_an_unknown_theme_and_a_theme_of_a_model_leave_no_file(
    tmp_path: File, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["draw", "braid-a3", "--theme", "blue", "-o", str(tmp_path / "a.svg")]) == 2
    assert "known are light, dark, mono" in capsys.readouterr().err
    assert main(["draw", "braid-a3", "--theme", "dark", "-o", str(tmp_path / "a.stl")]) == 2
    assert "theme is for pictures" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []
