"""A page on which convex pieces in space turn, in an exact order of painting for every direction.

The pieces hang on a tree of planes (see `depth_tree`): what is beyond a plane is painted first.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from arrangement.drawing.scene import Floats
from arrangement.drawing.solids.depth_tree import Node
from arrangement.drawing.solids.sight import unit
from arrangement.drawing.solids.surface import Patch, rounded

from .html_page import BASE_SCRIPT, BASE_STYLE, floats, one_page, own

SCRIPTS = (BASE_SCRIPT, *map(own, ("dual.js", "ball.js", "turning.js", "solid.js")))


@dataclass(frozen=True)
class PageFace:
    """A convex polygon, segment or point.

    Attributes:
        corners: (k, 3).
        fill: ``#rrggbb``, or ``#rrggbbaa`` to shine through.
        normal: outward; None for segments and points.
        edges: (e, 2, 3); the lines drawn.
        piece: the number of its description, or -1.
        middle: (3,) of the solid that it moves with, if it does.
        sheet: whether both sides are seen.
        faint: whether the lines are thin and grey.
        ink: of the lines, instead of black.
    """

    corners: Floats
    fill: str
    normal: Floats | None
    edges: Floats
    piece: int = -1
    middle: Floats | None = None
    sheet: bool = False
    faint: bool = False
    ink: str = ""


def page_face(patch: Patch, fill: str, piece: int, **style: Any) -> PageFace:
    """Return an exact piece as a face of a page."""
    edges = np.array([rounded(edge) for edge in patch.edges]).reshape(-1, 2, 3)
    normal = np.array(patch.row[:3], dtype=float) if any(patch.row) else None
    return PageFace(rounded(patch.corners), fill, normal, edges, piece, **style)


@dataclass
class SolidPage:
    """What a page shows.

    Attributes:
        title, summary, counts: texts.
        axes: (3, 3); the first view: right, up, towards the viewer.
        radius: of a ball around everything.
        tree: of faces; the first node is the root.
        pieces: name and facts of each piece.
        legend: colours with texts.
        frame: segments (k, 2, 3) behind everything.
        marks: texts at points, before everything.
        apart: how far solids stand apart at first, 1 for in place; 0 if they cannot.
    """

    title: str
    summary: str
    counts: str
    axes: Floats
    radius: float
    tree: Sequence[Node[PageFace]]
    pieces: list[tuple[str, list[tuple[str, str]]]]
    legend: list[tuple[str, str]]
    frame: Any = ()
    marks: Sequence[tuple[Any, str]] = ()
    apart: float = 0.0

    def text(self) -> str:
        """Return the page."""
        same = ("title", "summary", "counts", "legend", "apart")
        data = {key: getattr(self, key) for key in same} | {
            "axes": floats(self.axes),
            "radius": round(self.radius, 6),
            "nodes": [
                {"row": floats(node.row[:3]), "faces": list(map(_face, node.patches))}
                | {"front": node.front, "back": node.back}
                for node in self.tree
            ],
            "pieces": [{"name": name, "facts": facts} for name, facts in self.pieces],
            "frame": floats(self.frame),
            "marks": [{"at": floats(at), "text": text} for at, text in self.marks],
        }
        styles, tools = [BASE_STYLE, own("solid.css")], ["spin", "home", "theme", "print"]
        return one_page(self.title, own("solid.html"), styles, SCRIPTS, data, tools)


def _face(face: PageFace) -> dict[str, Any]:
    found: dict[str, Any] = {
        "at": floats(face.corners),
        "fill": face.fill,
        "edges": floats(face.edges),
        "piece": face.piece if face.piece >= 0 else None,
    }
    if face.normal is not None and face.normal.any():
        found["normal"] = floats(unit(face.normal))
    if face.middle is not None:
        found["middle"] = floats(face.middle)
    return found | {
        key: getattr(face, key) for key in ("sheet", "faint", "ink") if getattr(face, key)
    }
