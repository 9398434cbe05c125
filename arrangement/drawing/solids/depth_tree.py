"""Flat patches in space in an order in which none hides one that is painted later.

A plane with the viewer on one side: what lies beyond it cannot hide what lies in it, nor that what
lies before it. So patches are split along the planes of some of them until each part of space has
one plane at most (H. Fuchs, Z. Kedem, B. Naylor, SIGGRAPH 1980). Signs are exact. The tree does not
depend on the view.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Generic, TypeVar

import numpy as np

from arrangement.drawing.scene.scene import Floats, fitted
from arrangement.numbers.exact import IntegerVector, dot

from .flat_polygons import Segment, between, clipped
from .sight import picture_axes
from .surface import Patch, rounded

#: So many planes are tried for a split, and one patch cut counts as so many out of balance.
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

    def drawn_as(self, draw: Callable[[_Drawn], _Other]) -> Node[_Other]:
        """Return the same node with something else for each of its patches."""
        return Node(self.row, list(map(draw, self.patches)), self.front, self.back)


def depth_tree(patches: Sequence[Patch]) -> list[Node[Patch]]:
    """Return the nodes of a tree; the first one is the root. Patches may be cut."""
    nodes: list[Node[Patch]] = []
    todo: list[tuple[list[Patch], int, str]] = [(list(patches), -1, "")]
    while todo:
        group, parent, side = todo.pop()
        if not group:
            continue
        row = _best_row(group)
        node: Node[Patch] = Node(row)
        before, behind = [], []
        for patch in group:
            values = [dot(row, p) for p in patch.corners]
            if not any(values):
                node.patches.append(patch)
            else:
                before += _half(patch, row, 1)
                behind += _half(patch, row, -1)
        if parent >= 0:
            setattr(nodes[parent], side, len(nodes))
        nodes.append(node)
        todo += [(before, len(nodes) - 1, "front"), (behind, len(nodes) - 1, "back")]
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
    points = np.array([[x / p[3] for x in p] for patch in group for p in patch.corners])
    starts = np.cumsum([0, *(len(patch.corners) for patch in group)])[:-1]
    table = np.array([[x / max(map(abs, row)) for x in row] for row in chosen])
    values = points @ table.T
    above = np.maximum.reduceat(values, starts) > 1e-9
    below = np.minimum.reduceat(values, starts) < -1e-9
    cost = _CUT * (above & below).sum(axis=0) + np.abs(above.sum(axis=0) - below.sum(axis=0))
    return chosen[int(np.argmin(cost))]


def _half(patch: Patch, row: IntegerVector, side: int) -> list[Patch]:
    """Return the part of a patch on one side, if there is any."""
    values = [side * dot(row, p) for p in patch.corners]
    if max(values) <= 0:
        return []
    if min(values) >= 0:
        return [patch]
    edges = tuple(part for edge in patch.edges for part in _part(edge, row, side))
    return [replace(patch, corners=tuple(clipped(patch.corners, values)), edges=edges)]


def _part(edge: Segment, row: IntegerVector, side: int) -> list[Segment]:
    """Return the part of a segment on one side."""
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
        tree: of the pieces.
        towards: the viewer.
        points: (k, 3), whose box in the picture is to fill it.
        room: width of the sheet and what else `fitted` takes.
    """

    def __init__(
        self, tree: Sequence[Node[Patch]], towards: IntegerVector, points: Floats, *room: Any
    ) -> None:
        self.tree, self.towards = tree, towards
        self.axes = picture_axes(towards)
        flat = (points @ self.axes.T)[:, :2]
        self.scene, self.scale, self.shift = fitted(room[0], flat, *room[1:])

    def at(self, points: Any) -> Floats:
        """Return points of space on the scene."""
        placed: Floats = (np.asarray(points) @ self.axes.T)[..., :2] * self.scale + self.shift
        return placed

    def at_exact(self, points: Iterable[IntegerVector]) -> Floats:
        """Return homogeneous points of space on the scene."""
        return self.at(rounded(points))

    def faces(self, patch: Patch) -> bool:
        """Return whether the outer side of a piece is seen."""
        return bool(dot(patch.row[:3], self.towards) > 0)

    def layers(self, bottom: float) -> Iterator[tuple[float, list[Patch]]]:
        """Yield the pieces in each plane and their place in the order, from `bottom` to 1 more."""
        nodes = list(back_to_front(self.tree, self.towards))
        for k, node in enumerate(nodes):
            yield bottom + k / (len(nodes) + 1), node.patches
