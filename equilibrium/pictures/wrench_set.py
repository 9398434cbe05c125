"""The resisted wrenches in space as a solid: in a box, beside the grasp, as a page, as a model."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import product
from math import lcm
from operator import mul
from statistics import median
from typing import Any

import numpy as np

from arrangement.console.number_form import LABEL, counted
from arrangement.drawing.colours import BLACK, GREY, VERMILION, pale
from arrangement.drawing.pages import PageFace, SolidPage, page_face
from arrangement.drawing.scene import Floats, Legend, Scene, measure, millimetres
from arrangement.drawing.solids.depth_tree import Node, SolidSheet, depth_tree
from arrangement.drawing.solids.meshes import ClosedSurface, model_bytes
from arrangement.drawing.solids.sight import (
    best_view,
    light,
    picture_axes,
    turn_view,
    unit_vectors,
    view_direction,
    views,
)
from arrangement.drawing.solids.surface import Patch, float_points, surface
from arrangement.drawing.views import Exact, Vector, picture
from arrangement.errors import InputError
from arrangement.numbers.exact import (
    IntegerVector,
    RationalVector,
    dot,
    number_text,
    primitive,
    reduced,
    simplest_between,
)
from arrangement.numbers.linear.polyhedron import Polyhedron, from_conditions
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.model.labels import AS_ROUNDED
from equilibrium.wrench_sets import Piece, ResistedSet

from .grasp import GraspLayout, drawn
from .panel import clipped, explain_error, read_extent
from .style import MARKS, Wrench, nearest_float, symbol, ticks, wrench_text

#: How far the box reaches beyond the corners of the set, as a share of the largest extent.
_ROOM = Fraction(2, 5)
#: The middle and the sides of the box are known to this share of the sides.
_SHORT = Fraction(1, 1000)
#: Corners farther out than this many times the median do not count.
_FAR = 4
#: What is resisted, and where the box cuts it.
SOLID, CUT = "#5f93bd", "#e3ecf3"
NAMES = ("f_x", "f_y", "τ")
#: The walls of the box as outward rows, as inward ones, and their normals.
WALLS = tuple((*(s * int(i == j) for j in range(3)), -1) for i in range(3) for s in (1, -1))
_INWARD = [tuple(-x for x in row) for row in WALLS]
_NORMALS = np.array(WALLS, float)[:, :3]
#: The ends of the edges of the box, four along each axis.
_EDGES = np.array(
    [
        np.insert([sides, sides], axis, (-1, 1), axis=1)
        for axis in range(3)
        for sides in product((-1, 1), repeat=2)
    ]
)


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
    pieces: Sequence[Piece]
    shapes: Sequence[Polyhedron]

    def resists(self, wrench: RationalVector) -> bool:
        """Return whether a wrench is resisted."""
        return any(piece.polyhedron.contains(wrench) for piece in self.pieces)

    @cached_property
    def tree(self) -> list[Node[Patch]]:
        """The surface of the union and the axes in the box, in an order for painting."""
        zero = self.inside((Fraction(0),) * 3)
        axes = []
        for k in range(3):
            if all(abs(x) < 1 for j, x in enumerate(zero) if j != k):
                p, q = (
                    primitive([*zero[:k], Fraction(s), *zero[k + 1 :], Fraction(1)])
                    for s in (-1, 1)
                )
                axes.append(Patch((0,) * 4, (p, q), ((p, q),), sheet=True, name="axis"))
        return depth_tree([*surface(self.shapes), *axes])

    @cached_property
    def patches(self) -> list[Patch]:
        """All pieces of the tree but the axes."""
        return [p for node in self.tree for p in node.patches if p.name != "axis"]

    @cached_property
    def clear_side(self) -> IntegerVector:
        """A direction from above from which much of the set is seen, and little of the walls."""
        patches = [patch for patch in self.patches if len(patch.corners) > 2]
        areas = np.array([_area(patch) for patch in patches]).reshape(-1, 3)
        sheet = np.array([patch.sheet for patch in patches], dtype=bool)
        share = np.array([-1.0 if patch.row in WALLS else 1.0 for patch in patches])

        def score(seen: Sequence[IntegerVector]) -> Floats:
            towards = np.array(seen) @ areas.T
            towards = np.where(sheet, np.abs(towards), np.maximum(towards, 0.0))
            scores: Floats = towards @ share + np.array(seen) @ (0.001, -0.01, 0.1)
            return scores

        candidates = views((-9, -5, 5, 9), (-9, -5, 5, 9), (4, -4))
        return best_view([v for v in candidates if abs(v[0]) != abs(v[1])], score)

    def inside(self, wrench: RationalVector) -> RationalVector:
        """Return the place of a wrench in the coordinates of the box."""
        triples = zip(wrench, self.middle, self.half, strict=True)
        return tuple((x - m) / h for x, m, h in triples)

    @property
    def filled(self) -> bool:
        """Whether the set holds the whole box: it has volume, and no boundary inside the box."""
        return bool(self.patches) and all(p.row in WALLS and not p.sheet for p in self.patches)

    @property
    def endless(self) -> bool:
        """Whether the box cuts something off."""
        points = (point for shape in self.shapes for point in shape.points)
        return any(abs(x) == 1 for point in points for x in point)


def _area(patch: Patch) -> Floats:
    """Return the outward normal of a patch with the length of its area."""
    corners = float_points(patch.corners)
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
    middle, half = ((Fraction(0),) * 3, (extent,) * 3) if extent else _around(pieces)
    shapes = {piece: shape for piece in pieces if (shape := _inside(piece, middle, half))}
    return WrenchBox(middle, half, list(shapes), list(shapes.values()))


def _around(pieces: tuple[Piece, ...]) -> tuple[RationalVector, RationalVector]:
    """Return middle and half sides of a box around the corners, the origin among them."""
    points = [p for piece in pieces for p in piece.polyhedron.points]
    middle, half = [], []
    for column in zip(*points, strict=True) if points else ((),) * 3:
        sizes = [abs(nearest_float(x)) for x in column if x]
        limit = _FAR * median(sizes) if sizes else 0
        kept = [Fraction(0), *(x for x in column if abs(nearest_float(x)) <= limit)]
        low, high = min(kept, key=nearest_float), max(kept, key=nearest_float)
        middle.append((low + high) / 2)
        half.append((high - low) / 2)
    force = max(half[:2]) or Fraction(1)
    torque = half[2] or force
    sides = [x + _ROOM * x for x in (force, force, torque)]
    # Short numbers make coordinates in the box short.
    pairs = [(x, x * _SHORT) for x in sides]
    middles = (simplest_between(m - r, m + r) for m, (_, r) in zip(middle, pairs, strict=True))
    return tuple(middles), tuple(simplest_between(x, x + r) for x, r in pairs)


def _inside(piece: Piece, middle: RationalVector, half: RationalVector) -> Polyhedron | None:
    """Return the part of a piece in the box, in its coordinates."""
    shape, unit = piece.polyhedron, lcm(*(x.denominator for x in (*middle, *half)))
    start, sides = ([int(unit * x) for x in numbers] for numbers in (middle, half))

    def moved(row: IntegerVector) -> IntegerVector:
        return reduced([*map(mul, row, sides), dot(row, (*start, unit))])

    return from_conditions(
        [*map(moved, shape.inequalities), *_INWARD], map(moved, shape.equalities), 3
    )


def box_text(grasp: Grasp, box: WrenchBox) -> str:
    """Return the extent of a box in words."""
    units = f" ({grasp.units.force}, {grasp.units.torque})" if grasp.units else ""
    texts = [
        f"{name} {LABEL.number(m - h)} to {LABEL.number(m + h)}"
        for name, m, h in zip(NAMES, box.middle, box.half, strict=True)
    ]
    return f"box: {', '.join(texts)}{units}"


#: Room around the box for numbers and names, in points.
_MARGIN = 24.0
#: Below this width the grasp is left out; in millimetres.
_BOTH = 120.0
#: What the box cuts: the share of white in its faces; how far from the wall, in half sides, other
#: faces turn white, in this many steps, each with a veil of this opacity.
_CUT_WHITE, _FADE, _STEPS, _VEIL = 0.8, 0.3, 8, 0.12


@picture()
def draw_wrench_set(
    grasp: Grasp,
    *,
    wrench: Wrench | None = None,
    extent: Exact | None = None,
    camera: Vector | None = None,
    azimuth: float = 0.0,
    width: float = 180.0,
) -> Scene:
    """Draw all resisted wrenches (f_x, f_y, tau) as a solid in a box, beside the grasp.

    The set is a union of polyhedra, one for each choice of contact states, and need not be
    convex. Its surface is exact, and painted back to front in an exact order. Lines are its true
    edges. Pale hatched faces are where the box cuts what goes on; other faces fade towards them.
    Parts without volume are drawn as sheets and segments. Axes have their own scales; the numbers
    stand at the edges of the box.

    Elements: ``facet-3`` of the set, ``wall-4`` where the box cuts it, ``edge-5``, ``box-2``.

    Args:
        grasp: contacts.
        wrench: marked: a disc when it is resisted, a cross when not; where it lies behind the
            set it shines through.
        extent: half the sides of the box, about the origin; if omitted, the box holds the corners
            of the set, except single ones far out.
        camera: exact vector to the viewer, in the coordinates of the box; if omitted, from where
            much of the set is seen.
        azimuth: degrees by which the viewer moves to the right.
        width: of the figure, in millimetres; below 120 the grasp is left out.

    Raises:
        GraspError: an extent that is not above 0.
    """
    applied = None if wrench is None else read_wrench(wrench)
    box = wrench_box(grasp, read_extent(extent))
    towards = box.clear_side if camera is None else view_direction(camera)
    towards = turn_view(towards, azimuth)
    if width < _BOTH:
        return _WrenchSetPicture(grasp, box, towards, applied, width).scene
    right = _WrenchSetPicture(grasp, box, towards, applied, width * 0.6).scene
    left = drawn(GraspLayout(grasp), width * 0.4, right.paper[1])
    scene = Scene(width, max(left.paper[1], right.paper[1]))
    scene.place(left, 0.0, (scene.height - left.height) / 2)
    scene.place(right, left.width, (scene.height - right.height) / 2)
    return scene


def _maths(text: str) -> str:
    """Return a text with the names of wrenches as formulas."""
    return re.sub("f_[xy]|τ", lambda name: f"${name[0]}$".replace("τ", r"\tau"), text)


class _WrenchSetPicture(SolidSheet):
    """The picture of the set."""

    def __init__(
        self, grasp: Grasp, box: WrenchBox, towards: IntegerVector, applied: Any, width: float
    ) -> None:
        corners = np.array(list(product((-1.0, 1.0), repeat=3))) @ picture_axes(towards).T
        super().__init__(towards, width, (corners, (_MARGIN, _MARGIN)))
        self.grasp, self.box = grasp, box
        self._describe(self.scene.legend, applied)
        self._frame(behind=True)
        self._set()
        self._frame(behind=False)
        self._rulers()
        if applied is not None:
            self._mark(applied)

    def _describe(self, legend: Legend, applied: Any) -> None:
        box, units = self.box, self.grasp.units
        explain_error(legend, self.grasp)
        if not box.shapes:
            legend.line("nothing is resisted")
        legend.line(_maths(box_text(self.grasp, box)))
        if applied is not None:
            kind = "resisted" if box.resists(applied) else "refused"
            legend.key(symbol(kind), wrench_text(applied, units))
        if box.filled:
            text = "every wrench in the box is resisted; the set continues beyond it"
            legend.key(symbol(CUT), text)
            return
        if box.shapes:
            solid = any(shape.dimension > 1 for shape in box.shapes)
            legend.key(symbol(SOLID if solid else "border"), "resisted wrenches")
        if any(patch.row in WALLS for patch in box.patches):
            legend.key(symbol(f"{CUT} hatched"), "cut by the box; the set continues beyond it")
        elif box.endless:
            legend.line("what reaches the box continues beyond it")

    def _set(self) -> None:
        """Paint the surface back to front."""
        count = 0
        for z, patches in self.layers(self.box.tree, 2):
            seen = [p for p in patches if p.sheet or self.faces(p)]
            for patch in seen:
                count += 1
                self._patch(patch, count, z)
            for patch in seen:
                for edge in patch.edges:
                    style: dict[str, Any] = {"ec": BLACK, "lw": 0.8 if any(patch.row) else 1.5}
                    if patch.name:
                        style = {"ec": GREY, "lw": 0.5}
                    elif any(all(dot(row, p) == 0 for p in edge) for row in WALLS):
                        style = {"ec": GREY, "lw": 0.35}
                    style |= {"capstyle": "round", "gid": f"{patch.name or 'edge'}-{count}"}
                    self.scene.line(self.at_exact(edge), zorder=z, **style)
                if len(patch.corners) > 2 and patch.row not in WALLS:
                    self._fade(patch, z)

    def _patch(self, patch: Patch, count: int, z: float) -> None:
        corners = self.at_exact(patch.corners)
        if len(corners) == 1:
            self.scene.mark(corners[0], "o", 3.5, color=BLACK, zorder=z, gid=f"point-{count}")
        if len(corners) < 3:
            return
        wall = patch.row in WALLS
        normal = self.axes @ unit_vectors([patch.row[:3]])[0]
        fill = pale(SOLID, 0.45 * light(normal * math.copysign(1, normal[2])))
        fill = pale(fill, _CUT_WHITE) if wall else fill
        look: dict[str, Any] = {"gid": f"{'wall' if wall else 'facet'}-{count}", "role": "region"}
        self.scene.polygon(corners, fc=fill, ec=fill, lw=0.3, zorder=z, joinstyle="round", **look)
        if wall:
            self.scene.polygon(corners, fc="none", ec="#b5bcc3", lw=0, hatch="///", zorder=z)

    @cached_property
    def _cuts(self) -> dict[IntegerVector, list[Floats]]:
        """The normals of the walls that cut what the set has in each plane."""
        corners: dict[IntegerVector, list[IntegerVector]] = {}
        for patch in self.box.patches:
            corners.setdefault(patch.row, []).extend(patch.corners)
        heights = {row: float_points(points) @ _NORMALS.T for row, points in corners.items()}
        return {
            row: list(_NORMALS[(at.max(axis=0) > 1 - 1e-9) & (at.min(axis=0) <= 1 - _FADE)])
            for row, at in heights.items()
        }

    def _fade(self, patch: Patch, z: float) -> None:
        """Fade a face to white towards each wall that cuts its plane."""
        corners = float_points(patch.corners)
        style: dict[str, Any] = {"fc": "#ffffff", "ec": "none", "alpha": _VEIL, "gid": "fade"}
        for normal in self._cuts[patch.row]:
            for k in range(_STEPS):
                part = clipped(corners, normal, 1 - _FADE * (1 - k / _STEPS))
                if len(part) > 2:
                    self.scene.polygon(self.at(part), zorder=z, **style)

    def _facing(self, edge: Any) -> list[int]:
        """Return for both walls at an edge of the box how far they face the viewer."""
        sides = edge.sum(axis=0).tolist()
        return [s * t for s, t in zip(sides, self.towards, strict=True) if s]

    def _frame(self, *, behind: bool) -> None:
        """Draw the edges of the box, those behind the set first."""
        style: dict[str, Any] = {"zorder": 1} if behind else {"ls": (0, (4, 3)), "zorder": 4}
        style |= {"ec": "#a0a0a0", "lw": 0.4, "role": "border"}
        for k, edge in enumerate(_EDGES):
            if (min(self._facing(edge)) < 0) == behind:
                self.scene.line(self.at(edge), gid=f"box-{k}", **style)

    def _rulers(self) -> None:
        """Number one edge of the box for each axis, on the outline of the picture."""
        stated = self.grasp.units
        for axis, name in enumerate(NAMES):
            start, end, out = self._ruler(axis)
            for share, text in ticks(self.box.middle[axis], self.box.half[axis]):
                tick = self.at(start + (end - start) * (share + 1) / 2)
                self.scene.line([tick, tick + 2.5 * out], ec=GREY, lw=0.4, zorder=4, role="axis")
                reach = 4 + float(np.abs(out) @ measure(text)) / 2
                self.scene.write(tick + reach * out, text)
            unit = stated and (stated.torque if axis == 2 else stated.force)
            text = _maths(name) + (f" ({unit})" if unit else "")
            upright = 90.0 if unit and axis == 2 else 0.0
            beyond = max(0.0, measure(text, rotation=upright)[0] / 2 - 6)
            place = self.at([start, end]).mean(axis=0) + 19 * out + (out[0] * beyond, 0)
            self.scene.text(place, text, rotation=upright)

    def _ruler(self, axis: int) -> tuple[Any, Any, Floats]:
        """Return the ends of the numbered edge, and the direction on paper away from the box."""
        outer = [e for e in _EDGES[4 * axis :][:4] if min(f := self._facing(e)) <= 0 <= max(f)]
        low = 0 if axis == 2 else 1
        edge = min(outer, key=lambda edge: self.at(edge).mean(axis=0)[low])
        ruler = self.at(edge)
        along = ruler[1] - ruler[0]
        out = np.array([-along[1], along[0]]) / max(float(np.linalg.norm(along)), 1e-9)
        away = float(out @ (ruler.mean(axis=0) - self.at(np.zeros(3))))
        return edge[0], edge[1], out * math.copysign(1, away)

    def _mark(self, applied: Any) -> None:
        """Mark a wrench, and the point below it on the floor of the box."""
        place = np.array(self.box.inside(applied), float)
        if np.abs(place).max() > 1:
            return
        look: dict[str, Any] = {"lw": 0.5, "zorder": 5, "ls": (0, (1, 1.5)), "role": "line"}
        self.scene.line(self.at([place, [*place[:2], -1.0]]), ec=VERMILION, **look)
        sign, size, style = MARKS["resisted" if self.box.resists(applied) else "refused"]
        self.scene.mark(self.at(place), sign, size, zorder=6, gid="wrench", **style)


def wrench_set_page(
    grasp: Grasp,
    *,
    wrench: Wrench | None = None,
    extent: Exact | None = None,
    title: str | None = None,
) -> str:
    """Build a self-contained HTML page: the resisted wrenches as a solid, to rotate.

    Under the pointer a face shows its exact condition.

    Args:
        grasp: contacts.
        wrench: marked.
        extent: half the sides of the box, about the origin, as for the picture.
        title: a heading; if omitted, the number of contacts.

    Raises:
        GraspError: an extent that is not above 0.
    """
    box = wrench_box(grasp, read_extent(extent))
    number_of = grasp.size_words
    pieces: dict[IntegerVector, int] = {}
    facts: list[tuple[str, list[tuple[str, str]]]] = []

    def face(patch: Patch) -> PageFace:
        wall = patch.row in WALLS
        if any(patch.row) and patch.row not in pieces:
            pieces[patch.row] = len(facts)
            facts.append(_face_facts(box, patch, wall))
        number, faint = pieces.get(patch.row, -1), wall or patch.name == "axis"
        return page_face(patch, CUT if wall else SOLID, number, sheet=patch.sheet, faint=faint)

    zero = box.inside((Fraction(0),) * 3)
    marks: list[tuple[Any, str]] = [
        ([*zero[:k], 1.1, *zero[k + 1 :]], name) for k, name in enumerate(NAMES)
    ]
    if wrench is not None:
        applied = read_wrench(wrench)
        marks.append((box.inside(applied), "●" if box.resists(applied) else "✕"))
    return SolidPage(
        title if title is not None else f"Wrenches that {number_of} resist",
        box_text(grasp, box),
        f"{counted(len(box.shapes), 'polyhedron', 'polyhedra')}, one for each choice of contact "
        "states that is not a part of another" + (f"; {AS_ROUNDED}" if grasp.data_error else ""),
        picture_axes(box.clear_side),
        math.sqrt(3),
        [node.map_patches(face) for node in box.tree],
        facts,
        [(SOLID, "where resistance ends"), (CUT, "cut by the box, goes on")],
        _EDGES,
        marks,
    ).text()


def _face_facts(box: WrenchBox, patch: Patch, wall: bool) -> tuple[str, list[tuple[str, str]]]:
    """Return what the page says of a face: its condition on wrenches."""
    *normal, offset = patch.row
    row = [Fraction(a) / h for a, h in zip(normal, box.half, strict=True)]
    scaled = primitive([*row, -offset + sum(a * m for a, m in zip(row, box.middle, strict=True))])
    left = " ".join(
        f"{'-' if a < 0 else '+'} {'' if abs(a) == 1 else f'{number_text(abs(a))} '}{name}"
        for a, name in zip(scaled, NAMES, strict=False)
        if a
    ).removeprefix("+ ")
    name = (
        "Wall of the box" if wall else "Flat part of the set" if patch.sheet else "Face of the set"
    )
    return name, [("condition", f"{left} {'=' if patch.sheet else '≤'} {number_text(scaled[3])}")]


def wrench_set_model(
    grasp: Grasp, suffix: str, *, extent: Exact | None = None, size: float = 60.0
) -> bytes:
    """Build the resisted wrenches in a box as a model: one closed part for each polyhedron.

    Parts overlap where several equilibria exist. f_x, f_y and tau are x, y and z, each scaled so
    that the box is a cube. Parts are named by the contact states.

    Args:
        grasp: contacts.
        suffix: ``.stl``, ``.glb`` or ``.obj``.
        extent: half the sides of the box, about the origin, as for the picture.
        size: the longest side of the bounding box, in millimetres.

    Raises:
        GraspError: an extent that is not above 0.
        InputError: a set without volume.
    """
    box = wrench_box(grasp, read_extent(extent))
    half = millimetres(size, "size") / 2
    parts = []
    for piece, shape in zip(box.pieces, box.shapes, strict=True):
        if shape.dimension == 3:
            colours = tuple(CUT if row in _INWARD else SOLID for row in shape.inequalities)
            points = half * float_points(shape.homogeneous[0])
            parts.append(
                ClosedSurface("-".join(piece.states) or "all", points, shape.cycles, colours)
            )
    if not parts:
        raise InputError(
            "the resisted wrenches have no volume; draw them as a picture: .svg, .pdf or .png"
        )
    return model_bytes(
        parts, suffix, f"resisted wrenches, {counted(len(parts), 'polyhedron', 'polyhedra')}"
    )
