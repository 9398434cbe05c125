"""Scenes and files of views, paths of a figure, and what is wrong with the labels of a scene."""

import hashlib
import io
from collections import Counter
from collections.abc import Container, Iterable, Iterator
from contextlib import suppress
from typing import Any

import numpy as np
import shapely

from arrangement import InputError, read_arrangement
from arrangement.drawing.output import PICTURES, own_settings, picture_bytes
from arrangement.drawing.path_artist import figure
from arrangement.drawing.scene import Item, Label, Path, Scene, curve_points, measure
from arrangement.drawing.tikz import tikz
from arrangement.drawing.views import Drawings
from arrangement.library.families import generic
from arrangement.pictures import DRAWINGS as OF_PLANES
from equilibrium import read_grasp
from equilibrium.pictures import DRAWINGS as OF_GRASPS

VIEWS = [(drawings, view) for drawings in (OF_PLANES, OF_GRASPS) for view in drawings.views]
#: What a view cannot do without, or shows little without.
NEEDED: dict[str, dict[str, Any]] = {
    "methods": {"wrenches": [(0, 2, 0), (1, -1, 0)]},
    "proof": {"wrench": (0, -1, 0)},
    "grasp": {"wrench": (0, 1, 1)},
}


def paths(figure: Any) -> list[Path]:
    """Return the paths of all artists of a figure; see `arrangement.drawing.views`."""
    artists = [artist for axes in figure.axes for artist in axes.get_children()]
    return [item for artist in artists for item in getattr(artist, "items", ())]


def elements(made: Scene) -> Counter[str]:
    """Count the named elements of a scene by the part of the name before the first dash."""
    return Counter(item.name.partition("-")[0] for item in made.items)


def scene(drawings: Drawings, view: str, name: str = "", **options: Any) -> Scene:
    """Return the scene of a view of a built-in instance, in our own fonts."""
    usual = "braid-a3" if drawings is OF_PLANES else "paper-four-contacts"
    name = name or {"lines": "shi-a2-affine"}.get(view, usual)
    draw = drawings.function("view", view)
    read: Any = read_arrangement if drawings is OF_PLANES else read_grasp
    with own_settings():
        subject = generic(5, 4) if view == "section" else read(name)
        made: Scene = draw.scene(subject, **(NEEDED.get(view, {}) | options))
    return made


_KEPT: dict[tuple[str, str], Scene] = {}


def files(
    names: Iterable[str], whole: Container[str], tried: Container[str] = ()
) -> Iterator[tuple[str, str, Scene, dict[str, bytes]]]:
    """Yield views of built-in instances: instance, view, scene, and its files by their endings.

    What is in `whole` is drawn in every view, a third of them in all formats: writers read scenes
    alone, so a scene that is the same in SVG and TikZ is the same in all. The rest is drawn in
    these two, each instance in a seventh of the views and each view of a seventh of the instances;
    affine ones, which have few views, in all. What is in `tried` is drawn in the other formats as
    well, in few pixels: every warning is an error.
    """
    for k, (drawings, view) in enumerate(VIEWS):
        for j, name in enumerate(sorted(names)):
            if name not in whole and "affine" not in name and (j + k) % 7:
                continue
            with own_settings(), suppress(InputError):
                made = scene(drawings, view, name)
                for end in ("pdf", "png") if drawings is OF_PLANES and name in tried else ():
                    figure(made).savefig(io.BytesIO(), format=end, dpi=40)
                ends = PICTURES if name in whole and k % 3 == 0 else (".svg",)
                contents = {end: picture_bytes(end, lambda made=made: figure(made)) for end in ends}
                yield name, view, made, contents | {".tex": tikz(made).encode()}


def digests(name: str, view: str, contents: dict[str, bytes]) -> Iterator[str]:
    """Yield a line for each file of a view."""
    for end, content in contents.items():
        yield f"{name} {view} {end} {hashlib.sha256(content).hexdigest()}"


def usual(drawings: Drawings, view: str) -> Scene:
    """Return the scene with what a view shows by default, for tests that change nothing of it."""
    key = drawings.package, view
    _KEPT[key] = _KEPT.get(key) or scene(drawings, view)
    return _KEPT[key]


def box_of(label: Label) -> Any:
    """Return the rectangle of a text in our own settings."""
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
        return shapely.LineString(np.vstack([curve_points(item.points), item.points[-1:]]))
    points = item.points if item.kind == "line" else np.vstack([item.points, item.points[:1]])
    return shapely.LineString(points)


def offences(scene: Scene) -> list[str]:
    """Name the labels that leave the sheet, cover each other, or cover a line that is seen."""
    order = {id(item): (1.0 if item.order is None else item.order, k)
             for k, item in enumerate(scene.items)}  # fmt: skip
    labels = [item for item in scene.items if isinstance(item, Label) and item.text.strip()]
    lines = [item for item in scene.items if isinstance(item, Path) and is_line(item)]
    covers = [item for item in scene.items if isinstance(item, Path) and is_opaque(item)]
    with own_settings():
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
