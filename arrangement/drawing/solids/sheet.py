"""A scene on which flat pieces of solids are painted back to front."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from arrangement.drawing.scene.items import Floats
from arrangement.drawing.scene.scene import fitted
from arrangement.numbers.exact import IntegerVector, dot

from .depth_tree import Node, back_to_front
from .sight import picture_axes
from .surface import Patch


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

    def faces(self, patch: Patch) -> bool:
        """Return whether the outer side of a piece is seen."""
        return bool(dot(patch.row[:3], self.towards) > 0)

    def layers(self, bottom: float) -> Iterator[tuple[float, list[Patch]]]:
        """Yield the pieces in each plane and their place in the order, from `bottom` to 1 more."""
        nodes = list(back_to_front(self.tree, self.towards))
        for k, node in enumerate(nodes):
            yield bottom + k / (len(nodes) + 1), node.patches
