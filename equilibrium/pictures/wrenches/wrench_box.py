"""The resisted wrenches inside a box, in coordinates from -1 to 1, and the surface of the set."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import product
from math import lcm, prod
from operator import mul
from statistics import median

import numpy as np

from arrangement.console.number_form import LABEL
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.solids.depth_tree import Node, depth_tree
from arrangement.drawing.solids.sight import best_view, views
from arrangement.drawing.solids.surface import Patch, surface
from arrangement.numbers.exact import IntegerVector, RationalVector, dot, primitive, reduced
from arrangement.numbers.linear.polyhedron import Polyhedron, from_conditions
from equilibrium.grasps.inputs.conversion import simplest_between
from equilibrium.model.grasp import Grasp
from equilibrium.pictures.parts.style import rounded
from equilibrium.wrench_sets import Piece, ResistedSet

#: How far the box reaches beyond the corners of the set, as a share of the largest extent.
_ROOM = Fraction(2, 5)
#: The middle and the sides of the box are known to this share of the sides.
_SHORT = Fraction(1, 1000)
#: Corners farther out than this many times the median do not count.
_FAR = 4
#: What is resisted, and where the box cuts it.
SOLID, CUT = "#5f93bd", "#e3ecf3"
NAMES = ("f_x", "f_y", "τ")
#: The walls of the box as outward rows.
WALLS = tuple((*(s * int(i == j) for j in range(3)), -1) for i in range(3) for s in (1, -1))


@dataclass(frozen=True)
class WrenchBox:
    """What a grasp resists inside a box.

    Attributes:
        middle, half: of the box: exact, for f_x, f_y and tau.
        pieces: those that meet the box.
        shapes: their parts in the box, in its coordinates ``(w - middle) / half``.
    """

    middle: RationalVector
    half: RationalVector
    pieces: tuple[Piece, ...]
    shapes: tuple[Polyhedron, ...]

    @cached_property
    def tree(self) -> list[Node[Patch]]:
        """The surface of the union, in an order for painting."""
        return depth_tree([*surface(self.shapes), *self._axes()])

    def _axes(self) -> Iterator[Patch]:
        """Yield the lines through the origin of wrenches, as far as they are in the box."""
        zero = [-m / h for m, h in zip(self.middle, self.half, strict=True)]
        for k in range(3):
            if all(abs(x) < 1 for j, x in enumerate(zero) if j != k):
                ends = [[Fraction(s) if j == k else x for j, x in enumerate(zero)] for s in (-1, 1)]
                p, q = (primitive((*end, Fraction(1))) for end in ends)
                yield Patch((0,) * 4, (p, q), ((p, q),), sheet=True, name="axis")

    @cached_property
    def clear_side(self) -> IntegerVector:
        """A direction from above from which much of the set is seen, and little of the walls."""
        patches = [p for node in self.tree for p in node.patches if len(p.corners) > 2]
        areas = np.array([_area(patch) for patch in patches]).reshape(-1, 3)
        sheet = np.array([patch.sheet for patch in patches], dtype=bool)
        share = np.array([-1.0 if patch.row in WALLS else 1.0 for patch in patches])

        def score(seen: Sequence[IntegerVector]) -> Floats:
            towards = np.array(seen) @ areas.T
            towards = np.where(sheet, np.abs(towards), np.maximum(towards, 0.0))
            found: Floats = towards @ share + np.array(seen) @ (0.001, -0.01, 0.1)
            return found

        found = views((-9, -5, 5, 9), (-9, -5, 5, 9), (4, -4))
        return best_view([v for v in found if abs(v[0]) != abs(v[1])], score)

    def inside(self, wrench: RationalVector) -> list[float]:
        """Return the place of a wrench in the coordinates of the box."""
        pairs = zip(wrench, self.middle, self.half, strict=True)
        return [float((x - m) / h) for x, m, h in pairs]

    @property
    def filled(self) -> bool:
        """Whether the set holds the whole box: it has volume, and no boundary inside the box."""
        faces = [p for node in self.tree for p in node.patches if p.name != "axis"]
        return bool(faces) and all(p.row in WALLS and not p.sheet for p in faces)

    @property
    def endless(self) -> bool:
        """Whether the box cuts something off."""
        return any(
            dot(row, (*point, 1)) == 0
            for shape in self.shapes
            for point in shape.points
            for row in WALLS
        )


def _area(patch: Patch) -> Floats:
    """Return the outward normal of a patch with the length of its area."""
    corners = np.array([[x / p[3] for x in p[:3]] for p in patch.corners])
    steps = corners[1:] - corners[0]
    normal: Floats = np.cross(steps[:-1], steps[1:]).sum(axis=0) / 2
    outward = float(normal @ np.array(patch.row[:3], dtype=float))
    return normal if outward > 0 else -normal


def wrench_box(grasp: Grasp, extent: Fraction | None = None) -> WrenchBox:
    """Return the set of a grasp inside a box around its corners.

    Args:
        extent: half the sides of the box instead, about the origin, for forces and torque.
    """
    pieces = ResistedSet(grasp).polyhedra
    if extent is None:
        middle, half = _around(pieces)
    else:
        middle, half = (Fraction(0),) * 3, (extent,) * 3
    found = [(piece, shape) for piece in pieces if (shape := _inside(piece, middle, half))]
    return WrenchBox(middle, half, tuple(p for p, _ in found), tuple(s for _, s in found))


def _around(pieces: tuple[Piece, ...]) -> tuple[RationalVector, RationalVector]:
    """Return middle and half sides of a box around the corners, the origin among them."""
    points = [p for piece in pieces for p in piece.polyhedron.points]
    middle, half = [], []
    for column in zip(*points, strict=True) if points else ((),) * 3:
        sizes = [abs(rounded(x)) for x in column if x]
        limit = _FAR * median(sizes) if sizes else 0
        kept = [Fraction(0), *(x for x in column if abs(rounded(x)) <= limit)]
        low, high = min(kept, key=rounded), max(kept, key=rounded)
        middle.append((low + high) / 2)
        half.append((high - low) / 2)
    force = max(half[:2]) or Fraction(1)
    torque = half[2] or force
    sides = [x + _ROOM * x for x in (force, force, torque)]
    # Short numbers make coordinates in the box short.
    return (
        tuple(
            simplest_between(m - x * _SHORT, m + x * _SHORT)
            for m, x in zip(middle, sides, strict=True)
        ),
        tuple(simplest_between(x, x + x * _SHORT) for x in sides),
    )


def _inside(piece: Piece, middle: RationalVector, half: RationalVector) -> Polyhedron | None:
    """Return the part of a piece in the box, in its coordinates."""

    shape, unit = piece.polyhedron, lcm(*(x.denominator for x in (*middle, *half)))
    start, sides = ([int(unit * x) for x in numbers] for numbers in (middle, half))
    volume = prod(sides)

    def moved(row: IntegerVector) -> IntegerVector:
        return reduced([*map(mul, row, sides), dot(row, (*start, unit))])

    def place(point: IntegerVector) -> IntegerVector:
        *x, w = point
        steps = zip(x, start, sides, strict=True)
        return reduced([*((unit * p - w * m) * (volume // h) for p, m, h in steps), volume * w])

    rows = sorted(map(moved, shape.inequalities))
    points = sorted(map(place, shape.homogeneous[0])) if shape.bounded else []
    if shape.dimension == 3 and points and all(max(map(abs, p[:3])) < p[3] for p in points):
        return Polyhedron(tuple(rows), (), (tuple(points), ()))
    walls = [tuple(-x for x in row) for row in WALLS]
    return from_conditions([*rows, *walls], map(moved, shape.equalities), 3)


def box_text(grasp: Grasp, box: WrenchBox) -> str:
    """Return the extent of a box in words."""
    units = f" ({grasp.units.force}, {grasp.units.torque})" if grasp.units else ""
    texts = [
        f"{name} {LABEL.number(m - h)} to {LABEL.number(m + h)}"
        for name, m, h in zip(NAMES, box.middle, box.half, strict=True)
    ]
    return f"box: {', '.join(texts)}{units}"


def box_edges() -> Iterator[tuple[Floats, tuple[int, tuple[int, ...]]]]:
    """Yield the ends of the edges of the box, each with its axis and its sides of the others."""
    for axis in range(3):
        for sides in product((-1, 1), repeat=2):
            ends = np.zeros((2, 3))
            ends[:, axis], ends[:, [k for k in range(3) if k != axis]] = (-1, 1), sides
            yield ends, (axis, sides)
