"""Every label of every view: on the sheet, over no other label, over no line that is seen."""

from __future__ import annotations

import contextlib
import importlib
from typing import Any

import numpy as np
import pytest
import shapely

from arrangement import InputError
from arrangement.drawing.output import own_settings
from arrangement.drawing.scene.items import Item, Label, Path
from arrangement.drawing.scene.labels import flattened
from arrangement.drawing.scene.layout import laid_out
from arrangement.drawing.scene.measuring import measure
from arrangement.drawing.scene.scene import Scene
from arrangement.library.files.table import read_arrangement
from arrangement.pictures import DRAWINGS

INSTANCES = [
    "braid-a3", "braid-a3-in-r4", "coincident-planes", "coordinate-planes", "cube-diagonals",
    "five-generic-planes", "four-generic-planes", "generic-lines-affine", "near-pencil",
    "nine-generic-planes", "parallel-planes-affine", "pencil", "reflection-b3", "shi-a2-affine",
    "three-generic-planes",
]  # fmt: skip
GRASPS = ["paper-three-contacts", "paper-four-contacts", "offset-three-contacts"]
OTHER_OPTIONS: list[tuple[str, str, dict[str, Any]]] = [
    ("sphere", "reflection-b3", {"labels": "signs"}),
    ("sphere", "braid-a3", {"sides": True, "axes": "x,y,z"}),
    ("sphere", "five-generic-planes", {"antipodes": "same", "width": 60.0}),
    ("planes", "cube-diagonals", {"lift": ["++++", "+-+-"], "sides": True, "axes": "x,y,z"}),
    ("planes", "braid-a3", {"lift": ["++++++"], "body": "cube"}),
    ("stereographic", "reflection-b3", {"whole": True, "labels": "signs"}),
    ("gnomonic", "reflection-b3", {"direction": (0, 0, 1)}),
    ("dual", "five-generic-planes", {"hull": True}),
    ("dual", "reflection-b3", {"width": 88.0}),
    ("graph", "reflection-b3", {"labels": "signs"}),
    ("lines", "generic-lines-affine", {"faces": "all", "sides": True}),
    ("lines", "pencil", {"projective": True, "sides": True}),
    ("lines", "shi-a2-affine", {"projective": True, "labels": "signs", "colour": "sides"}),
    ("cells", "cube-diagonals", {"body": "ball", "explode": 2}),
    ("lattice", "reflection-b3", {"width": 180.0, "moebius": False}),
]


def scene_of(view: str, name: str, **options: Any) -> Scene:
    module, _, function = DRAWINGS.views[view].partition(":")
    draw = getattr(importlib.import_module(f"arrangement.pictures.{module}"), function)
    with own_settings():
        scene: Scene = laid_out(draw.scene(read_arrangement(name), **options))
    return scene


def box_of(label: Label) -> Any:
    """Return the rectangle of a text."""
    with own_settings():
        w, h = measure(label.text, label.size, label.rotation)
    x, y = label.place
    left = x - w * {"left": 0.0, "center": 0.5, "right": 1.0}[label.ha]
    share = {"bottom": 0.0, "baseline": 0.2, "center": 0.5, "center_baseline": 0.5, "top": 1.0}
    low = y - h * share[label.va]
    return shapely.box(left, low, left + w, low + h)


def shape_of(item: Path) -> Any:
    """Return the line of a path, closed where it is drawn closed."""
    if item.kind == "circle":
        return shapely.Point(item.points).buffer(item.radius).exterior
    if item.kind == "curve":
        return shapely.LineString(np.vstack([flattened(item.points), item.points[-1:]]))
    points = item.points if item.kind == "line" else np.vstack([item.points, item.points[:1]])
    return shapely.LineString(points)


def offences(scene: Scene) -> list[str]:
    """Name the labels that leave the sheet, cover each other, or cover a line that is seen."""
    order = {id(item): (1.0 if item.order is None else item.order, k)
             for k, item in enumerate(scene.items)}  # fmt: skip
    labels = [item for item in scene.items if isinstance(item, Label) and item.text.strip()]
    lines = [item for item in scene.items if isinstance(item, Path) and is_line(item)]
    covers = [item for item in scene.items if isinstance(item, Path) and is_opaque(item)]
    boxes = [box_of(label) for label in labels]
    sheet = shapely.box(0, 0, scene.width, scene.height).buffer(0.01)
    found = [label.text for label, box in zip(labels, boxes, strict=True) if not sheet.covers(box)]
    tree = shapely.STRtree(boxes)
    inner = np.array([box.buffer(-0.2) for box in boxes], dtype=object)
    found += [
        f"{labels[a].text!r} and {labels[b].text!r}"
        for a, b in tree.query(inner, "intersects").T.tolist()
        if a < b and inner[a].intersects(inner[b])
    ]
    shapes = shapely.STRtree([shape_of(line) for line in lines])
    areas = shapely.STRtree([shapely.Polygon(shape_of(item)) for item in covers])
    for a, k in shapes.query(inner, "intersects").T.tolist():
        above = [
            areas.geometries[j]
            for j in areas.query(inner[a], "intersects").tolist()
            if order[id(lines[k])] < order[id(covers[j])] < order[id(labels[a])]
        ]
        seen = shapes.geometries[k].difference(shapely.union_all(above))
        if seen.intersects(inner[a]):
            found.append(f"{labels[a].text!r} on {lines[k].name or lines[k].role}")
    return found


def is_line(item: Item) -> bool:
    """Return whether a line of its own colour is seen; seams between faces have that of these."""
    style = item.style
    edge = style.get("ec", "black")
    return str(edge) != "none" and edge != style.get("fc") and style.get("lw", 1.0) > 0


def is_opaque(item: Path) -> bool:
    filled = item.kind in ("polygon", "circle") and str(item.style.get("fc", "none")) != "none"
    return filled and item.style.get("fill", True) and item.style.get("alpha", 1) == 1


@pytest.mark.campaign
@pytest.mark.parametrize("name", [*INSTANCES, *GRASPS])
@pytest.mark.parametrize("view", DRAWINGS.views)
def test_no_label_is_cut_off_or_covers_another_or_an_edge(view: str, name: str) -> None:
    with contextlib.suppress(InputError):  # some views refuse affine planes, or other spaces
        assert offences(scene_of(view, name)) == []


@pytest.mark.campaign
@pytest.mark.parametrize(("view", "name", "options"), OTHER_OPTIONS)
def test_nor_with_other_options(view: str, name: str, options: dict[str, Any]) -> None:
    assert offences(scene_of(view, name, **options)) == []


def test_the_check_finds_each_kind_of_offence() -> None:
    with own_settings():
        scene = Scene(40, 40)
        scene.text((50, 50), "one")
        scene.line([(40, 50), (60, 50)], ec="black", gid="edge-1")
        assert offences(scene) == ["'one' on edge-1"]
        scene.circle((50, 50), 15, fc="white", ec="none", zorder=2)
        assert offences(scene) == []
        scene.text((53, 50), "two")
        scene.text((1, 90), "three")
        assert offences(scene) == ["three", "'one' and 'two'"]
