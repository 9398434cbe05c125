"""The legend of a picture: where it stands, how much room it takes, what it never covers."""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import Any

import pytest

from arrangement import InputError, read_arrangement
from arrangement.drawing.output import own_settings
from arrangement.drawing.registry import Drawings
from arrangement.drawing.scene.items import Label
from arrangement.drawing.scene.layout import BELOW, laid_out, picture_width
from arrangement.drawing.scene.measuring import measure
from arrangement.drawing.scene.scene import Scene
from arrangement.pictures import DRAWINGS as OF_PLANES
from equilibrium import read_grasp
from equilibrium.pictures import DRAWINGS as OF_GRASPS

SUBJECTS = {
    "arrangement.pictures": read_arrangement("five-generic-planes"),
    "equilibrium.pictures": read_grasp("paper-three-contacts-preload-1"),
}
OPTIONS: dict[str, dict[str, Any]] = {
    "methods": {"wrenches": [(0, 1, 0), (1, 0, 0)]},
    "proof": {"wrench": (0, 3, 0)},
    "grasp": {"wrench": (0, 1, 0)},
}
VIEWS = [(d, view) for d in (OF_PLANES, OF_GRASPS) for view in d.views if view != "lines"]


def scene_of(drawings: Drawings, view: str, **options: Any) -> Scene:
    module, _, name = drawings.views[view].partition(":")
    draw = getattr(importlib.import_module(f"{drawings.package}.{module}"), name)
    subject = SUBJECTS[drawings.package]
    made: Scene = draw.scene(subject, **OPTIONS.get(view, {}), **options)
    return made


@pytest.mark.parametrize(("drawings", "view"), VIEWS)
def test_keys_and_lines_below_take_a_sixth_of_the_height(drawings: Drawings, view: str) -> None:
    with own_settings():
        scene = scene_of(drawings, view)
        scene.legend.captions.clear()
        scene.legend.table.clear()
        sheet = laid_out(scene)
        assert sheet.height - scene.height <= BELOW * sheet.height + 1e-6
        assert sheet.width == scene.width
        assert laid_out(scene, "none").height == scene.height


@pytest.mark.parametrize(("drawings", "view"), VIEWS)
def test_at_the_right_it_stands_beside_the_picture(drawings: Drawings, view: str) -> None:
    wide = 260.0
    with own_settings():
        scene = scene_of(drawings, view, width=picture_width(wide, "right"))
        count, keys = len(scene.items), scene.legend.keys
        sheet = laid_out(scene, "right")
        assert sheet.paper[0] == pytest.approx(wide)
        texts = [item for item in sheet.items[count:] if isinstance(item, Label)]
        assert {word for key in keys for word in key.text.split()} <= {
            word for item in texts for word in item.text.split()
        }
        captions = {line for text in scene.legend.captions for line in text.split()}
        for item in texts:
            w, h = measure(item.text, item.size)
            beside = item.place[0] >= scene.width and item.place[0] + w <= sheet.width + 0.01
            assert beside or set(item.text.split()) <= captions
            assert h / 2 - 1 <= item.place[1] <= sheet.height


def test_without_a_legend_captions_stay(tmp_path: Path) -> None:
    planes = read_arrangement("braid-a3-in-r4")
    for legend, shown in (("none", False), ("below", True)):
        path = tmp_path / f"{legend}.svg"
        OF_PLANES.write(planes, path, "sphere", legend=legend, text="text")
        svg = path.read_text(encoding="utf-8")
        assert "essentialisation" in svg
        assert ("odd number" in svg) == shown


def test_a_place_that_does_not_exist_names_the_nearest(tmp_path: Path) -> None:
    planes = SUBJECTS["arrangement.pictures"]
    with pytest.raises(InputError, match="did you mean below"):
        OF_PLANES.write(planes, tmp_path / "a.svg", "sphere", legend="belw")
    with pytest.raises(InputError, match="legend or theme is for pictures"):
        OF_PLANES.write(planes, tmp_path / "a.html", legend="below")
    with pytest.raises(InputError, match="without the legend at the right"):
        OF_PLANES.write(planes, tmp_path / "a.svg", "sphere", legend="right", width=45.0)
    assert list(tmp_path.iterdir()) == []
