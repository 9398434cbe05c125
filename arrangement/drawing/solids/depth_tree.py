"""Pieces in space in an order in which none hides one that is painted later.

A plane with the viewer on one side: what lies beyond it cannot hide what lies in it, nor that what
lies before it. So flat patches are split along the planes of some of them until each part of space
has one plane at most (H. Fuchs, Z. Kedem, B. Naylor, SIGGRAPH 1980). Pieces that planes cut out,
such as the cells of an arrangement and their facets, hang on the tree of these planes. Signs are
exact. The tree does not depend on the view.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Generic, TypeAlias, TypeVar

import numpy as np

from arrangement.drawing.scene import Floats, Margins, fit_sheet
from arrangement.numbers.exact import IntegerVector, dot

from .flat_polygons import Segment, between, clip_polygon
from .sight import picture_axes
from .surface import Patch, float_points

#: This many planes are tried for a split, and one patch cut counts as this many out of balance.
_TRIED, _CUT = 12, 8


_Drawn = TypeVar("_Drawn")
_Other = TypeVar("_Other")


@dataclass
class Node(Generic[_Drawn]):
    """A plane, the patches in it, and what lies before and behind it; children by number.

    Attributes:
        row: ``(a, b)``; ``a . x + b > 0`` in front. Zeros if there are only segments and points.
        patches: in the plane.
        front, back: numbers of nodes; -1 for nothing.
    """

    row: IntegerVector
    patches: list[_Drawn] = field(default_factory=list)
    front: int = -1
    back: int = -1

    def map_patches(self, draw: Callable[[_Drawn], _Other]) -> Node[_Other]:
        """Return the same node with something else for each of its patches."""
        return Node(self.row, list(map(draw, self.patches)), self.front, self.back)


#: A plane, what lies in it, before it and behind it.
_Parts: TypeAlias = tuple[IntegerVector, list[_Drawn], list[_Other], list[_Other]]


def depth_tree(
    patches: Iterable[Patch], whole: Callable[[Sequence[Patch]], bool] | None = None
) -> list[Node[Patch]]:
    """Return the nodes of a tree; the first one is the root. Patches may be cut.

    Args:
        whole: which patches need no order, as those of one convex solid that are seen.
    """

    def split(group: Sequence[Patch]) -> _Parts[Patch, Patch]:
        if whole is not None and whole(group):
            return (0,) * 4, list(group), [], []
        row = _best_row(group)
        inside = [patch for patch in group if not any(dot(row, p) for p in patch.corners)]
        return row, inside, halves(group, row, 1), halves(group, row, -1)

    return _tree(list(patches), split)


def plane_tree(
    rows: Sequence[IntegerVector], pieces: Iterable[tuple[Sequence[int], _Drawn]]
) -> list[Node[_Drawn]]:
    """Return the tree of given planes; the first node is the root, and none has one side only.

    Args:
        rows: the planes.
        pieces: each with its side of every plane: 1 in front, -1 behind, 0 in the plane.
    """

    def split(group: Sequence[tuple[Sequence[int], _Drawn]]) -> _Parts[_Drawn, Any]:
        columns = zip(*(sides for sides, _ in group), strict=True)
        k = next((k for k, at in enumerate(columns) if 0 in at or len(set(at)) > 1), None)
        if k is None:
            return (0,) * 4, [piece for _, piece in group], [], []
        parts = ([entry for entry in group if entry[0][k] == side] for side in (0, 1, -1))
        inside, before, behind = parts
        return rows[k], [piece for _, piece in inside], before, behind

    return _tree(list(pieces), split)


def _tree(
    pieces: list[_Other], split: Callable[[Sequence[_Other]], _Parts[_Drawn, _Other]]
) -> list[Node[_Drawn]]:
    """Return the nodes of the tree that `split` makes of pieces, again and again."""
    nodes: list[Node[_Drawn]] = []
    todo = [(pieces, -1, "")]
    while todo:
        group, parent, side = todo.pop()
        if not group:
            continue
        row, inside, before, behind = split(group)
        if parent >= 0:
            setattr(nodes[parent], side, len(nodes))
        todo += [(before, len(nodes), "front"), (behind, len(nodes), "back")]
        nodes.append(Node(row, inside))
    return nodes


def join_trees(
    row: IntegerVector, front: Sequence[Node[_Drawn]], back: Sequence[Node[_Drawn]]
) -> list[Node[_Drawn]]:
    """Return the tree of a plane, with trees of what is before it and behind it."""
    nodes: list[Node[_Drawn]] = [Node(row)]
    for side, part in (("front", front), ("back", back)):
        by = len(nodes)
        if part:
            setattr(nodes[0], side, by)
        for node in part:
            ends = (k + by if k >= 0 else k for k in (node.front, node.back))
            nodes.append(Node(node.row, node.patches, *ends))
    return nodes


def back_to_front(
    nodes: Sequence[Node[_Drawn]], direction: IntegerVector
) -> Iterator[Node[_Drawn]]:
    """Yield the nodes in the order of painting, for a direction towards the viewer."""
    todo = [(0, False)] if nodes else []
    while todo:
        k, ready = todo.pop()
        if k < 0:
            continue
        node = nodes[k]
        if ready:
            yield node
            continue
        ahead = dot(node.row[:3], direction) > 0
        near, far = (node.front, node.back) if ahead else (node.back, node.front)
        todo += [(near, False), (k, True), (far, False)]


def _best_row(group: Sequence[Patch]) -> IntegerVector:
    """Return the plane that cuts few of the patches and leaves its sides balanced."""
    rows = sorted({patch.row for patch in group if any(patch.row)})
    if not rows:
        return (0,) * 4
    chosen = rows[:: max(1, len(rows) // _TRIED)]
    points = np.array([[float(x / p[3]) for x in p] for patch in group for p in patch.corners])
    starts = np.cumsum([0, *(len(patch.corners) for patch in group)])[:-1]
    table = np.array([[float(x / max(map(abs, row))) for x in row] for row in chosen])
    values = points @ table.T
    above = np.maximum.reduceat(values, starts) > 1e-9
    below = np.minimum.reduceat(values, starts) < -1e-9
    cost = _CUT * (above & below).sum(axis=0) + np.abs(above.sum(axis=0) - below.sum(axis=0))
    return chosen[int(np.argmin(cost))]


def halves(patches: Iterable[Patch], row: IntegerVector, side: int) -> list[Patch]:
    """Return the parts of patches on one side of a plane; none of those that lie in it."""
    parts = []
    for patch in patches:
        values = [side * dot(row, p) for p in patch.corners]
        if min(values) >= 0 and any(values):
            parts.append(patch)
        elif max(values) > 0:
            edges = tuple(part for edge in patch.edges for part in _part(edge, row, side))
            corners = tuple(clip_polygon(patch.corners, values))
            parts.append(replace(patch, corners=corners, edges=edges))
    return parts


def _part(edge: Segment, row: IntegerVector, side: int) -> list[Segment]:
    (p, q), (at_p, at_q) = edge, (side * dot(row, x) for x in edge)
    if at_p < 0 or at_q < 0:
        if max(at_p, at_q) <= 0:
            return []
        cut = between(p, q, at_p, at_q)
        return [(p, cut) if at_p > 0 else (cut, q)]
    return [edge] if at_p or at_q else []


class SolidSheet:
    """A picture of pieces in space, seen from a direction.

    Args:
        towards: the viewer.
        width, parts, tallest: as for `fit_sheet`; points in the axes of the picture.
    """

    def __init__(
        self,
        towards: IntegerVector,
        width: float,
        *parts: tuple[Floats, Margins],
        tallest: float | None = math.inf,
    ) -> None:
        self.towards, self.axes = towards, picture_axes(towards)
        self.scene, self.scale, self.shift = fit_sheet(width, *parts, tallest=tallest)

    def place(self, points: Any) -> Floats:
        """Return points in the axes of the picture (.., 2 or 3) on the scene."""
        return np.asarray(points)[..., :2] * self.scale + self.shift

    def at(self, points: Any) -> Floats:
        """Return points of space on the scene."""
        return self.place(np.asarray(points) @ self.axes.T)

    def at_exact(self, points: Iterable[IntegerVector]) -> Floats:
        """Return homogeneous points of space on the scene."""
        return self.at(float_points(points))

    def faces(self, patch: Patch) -> bool:
        """Return whether the outer side of a piece is seen."""
        return bool(dot(patch.row[:3], self.towards) > 0)

    def layers(
        self, tree: Sequence[Node[_Drawn]], bottom: float
    ) -> Iterator[tuple[float, list[_Drawn]]]:
        """Yield the pieces in each plane and their place in the order, from `bottom` to 1 more."""
        nodes = list(back_to_front(tree, self.towards))
        for k, node in enumerate(nodes):
            yield bottom + k / (len(nodes) + 1), node.patches
