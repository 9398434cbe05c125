"""The resisted wrenches in space as a solid, beside the grasp."""

from __future__ import annotations

import math
import re
from functools import cached_property
from itertools import product
from typing import Any

import numpy as np

from arrangement.drawing.colours import BLACK, GREY, VERMILION, pale
from arrangement.drawing.figure import picture
from arrangement.drawing.registry import Exact, Vector
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.scene.scene import Legend, Scene
from arrangement.drawing.solids.depth_tree import SolidSheet
from arrangement.drawing.solids.sight import (
    light,
    picture_axes,
    turned,
    unit_vectors,
    view_direction,
)
from arrangement.drawing.solids.surface import Patch, rounded
from arrangement.numbers.exact import IntegerVector, dot
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.pictures.grasp.grasp import drawn
from equilibrium.pictures.grasp.layout import Layout
from equilibrium.pictures.parts.panel import explain_error, read_extent
from equilibrium.pictures.parts.style import MARKS, Wrench, symbol, ticks, wrench_text
from equilibrium.pictures.parts.window import clipped

from .wrench_box import CUT, NAMES, SOLID, WALLS, WrenchBox, box_edges, box_text, wrench_box

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
    towards = turned(towards, azimuth)
    if width < _BOTH:
        return _WrenchSetPicture(grasp, box, towards, applied, width).scene
    right = _WrenchSetPicture(grasp, box, towards, applied, width * 0.6).scene
    left = drawn(Layout(grasp), width * 0.4, right.paper[1])
    scene = Scene(width, max(left.paper[1], right.paper[1]))
    scene.place(left, 0.0, (scene.height - left.height) / 2)
    scene.place(right, left.width, (scene.height - right.height) / 2)
    return scene


def _maths(text: str) -> str:
    """Return a text with the names of wrenches as formulas."""
    return re.sub("f_[xy]|τ", lambda found: f"${found[0]}$".replace("τ", r"\tau"), text)


def _lit(normal: Floats) -> str:
    """Return the colour of a face of the set, by the angle to the light."""
    return pale(SOLID, 0.45 * light(normal))


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
        explain_error(legend, self.grasp)
        if not self.box.shapes:
            legend.line("nothing is resisted")
        legend.line(_maths(box_text(self.grasp, self.box)))
        if applied is not None:
            held = any(piece.polyhedron.contains(applied) for piece in self.box.pieces)
            legend.key(
                symbol("resisted" if held else "refused"), wrench_text(applied, self.grasp.units)
            )
        solid = any(shape.dimension > 1 for shape in self.box.shapes)
        if self.box.filled:
            text = "every wrench in the box is resisted; the set continues beyond it"
            legend.key(symbol(CUT), text)
            return
        if self.box.shapes:
            legend.key(symbol(SOLID if solid else "border"), "resisted wrenches")
        if any(p.row in WALLS for node in self.box.tree for p in node.patches):
            legend.key(symbol(f"{CUT} hatched"), "cut by the box; the set continues beyond it")
        elif self.box.endless:
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
                wall = patch.row in WALLS
                style = {"ec": GREY, "lw": 0.35} if wall else {"ec": BLACK, "lw": 0.8}
                kind = patch.name or "edge"
                if kind == "axis":
                    style = {"ec": GREY, "lw": 0.5}
                elif len(patch.corners) == 2:
                    style["lw"] = 1.5
                for edge in patch.edges:
                    on_wall = any(all(dot(row, p) == 0 for p in edge) for row in WALLS)
                    cut = {"ec": GREY, "lw": 0.35} if kind != "axis" and on_wall else {}
                    look: dict[str, Any] = {"gid": f"{kind}-{count}", "capstyle": "round"}
                    self.scene.line(self.at_exact(edge), zorder=z, **{**style, **cut}, **look)
                if len(patch.corners) > 2 and not wall:
                    self._fade(patch, z)

    def _patch(self, patch: Patch, count: int, z: float) -> None:
        corners = self.at_exact(patch.corners)
        if len(corners) == 1:
            self.scene.mark(corners[0], "o", 3.5, color=BLACK, zorder=z, gid=f"point-{count}")
        if len(corners) < 3:
            return
        wall = patch.row in WALLS
        normal = self.axes @ unit_vectors([patch.row[:3]])[0]
        normal *= math.copysign(1, normal[2])
        fill = pale(_lit(normal), _CUT_WHITE) if wall else _lit(normal)
        look: dict[str, Any] = {"gid": f"{'wall' if wall else 'facet'}-{count}", "role": "region"}
        self.scene.polygon(corners, fc=fill, ec=fill, lw=0.3, zorder=z, joinstyle="round", **look)
        if wall:
            self.scene.polygon(corners, fc="none", ec="#b5bcc3", lw=0, hatch="///", zorder=z)

    @cached_property
    def _cuts(self) -> dict[tuple[int, ...], list[tuple[int, int]]]:
        """The walls, as axis and side, that cut what the set has in each plane."""
        found: dict[tuple[int, ...], list[Floats]] = {}
        for patch in (p for node in self.box.tree for p in node.patches if len(p.corners) > 2):
            found.setdefault(patch.row, []).append(rounded(patch.corners))
        corners = {row: np.concatenate(parts) for row, parts in found.items()}
        sides = list(product(range(3), (1, -1)))
        return {
            row: [
                (axis, side)
                for axis, side in sides
                if (side * at[:, axis]).max() > 1 - 1e-9 and (side * at[:, axis]).min() <= 1 - _FADE
            ]
            for row, at in corners.items()
        }

    def _fade(self, patch: Patch, z: float) -> None:
        """Fade a face to white towards each wall that cuts its plane."""
        corners = rounded(patch.corners)
        for axis, side in self._cuts[patch.row]:
            for k in range(_STEPS):
                part = clipped(corners, side * np.eye(3)[axis], 1 - _FADE * (1 - k / _STEPS))
                if len(part) > 2:
                    self.scene.polygon(
                        self.at(part), fc="#ffffff", ec="none", alpha=_VEIL, zorder=z, gid="fade"
                    )

    def _frame(self, *, behind: bool) -> None:
        """Draw the edges of the box, those behind the set first."""
        for k, (ends, (axis, sides)) in enumerate(box_edges()):
            others = (j for j in range(3) if j != axis)
            far = any(s * self.towards[j] < 0 for s, j in zip(sides, others, strict=True))
            if far == behind:
                style = {"zorder": 1} if behind else {"ls": (0, (4, 3)), "zorder": 4}
                self.scene.line(
                    self.at(ends), ec="#a0a0a0", lw=0.4, role="border", gid=f"box-{k}", **style
                )

    def _rulers(self) -> None:
        """Number one edge of the box for each axis, on the outline of the picture."""
        for axis, name in enumerate(NAMES):
            ends, out = self._ruler(axis)
            for share, text in ticks(self.box.middle[axis], self.box.half[axis]):
                tick = self.at(ends[0] + (ends[1] - ends[0]) * (share + 1) / 2)
                self.scene.line([tick, tick + 2.5 * out], ec=GREY, lw=0.4, zorder=4, role="axis")
                half_box = np.array(self.scene.measure(text)) / 2
                reach = 4 + abs(out[0]) * half_box[0] + abs(out[1]) * half_box[1]
                self.scene.write(tick + reach * out, text)
            unit = self.grasp.units and (
                self.grasp.units.torque if axis == 2 else self.grasp.units.force
            )
            text = _maths(name) + (f" ({unit})" if unit else "")
            upright = 90.0 if unit and axis == 2 else 0.0
            beyond = max(0.0, self.scene.measure(text, rotation=upright)[0] / 2 - 6)
            place = self.at(ends).mean(axis=0) + 19 * out + (out[0] * beyond, 0)
            self.scene.text(place, text, rotation=upright)

    def _ruler(self, axis: int) -> tuple[Floats, Floats]:
        """Return the ends of the numbered edge, and the direction on paper away from the box."""
        others = [k for k in range(3) if k != axis]
        best: tuple[float, Any, Any] | None = None
        for ends, (own, sides) in box_edges():
            visible = {s * self.towards[k] > 0 for s, k in zip(sides, others, strict=True)}
            if own != axis or (len(visible) < 2 and all(self.towards[k] for k in others)):
                continue
            ruler = self.at(ends)
            along = ruler[1] - ruler[0]
            out = np.array([-along[1], along[0]]) / max(float(np.linalg.norm(along)), 1e-9)
            middle = ruler.mean(axis=0)
            out *= math.copysign(1, float(out @ (middle - self.at(np.zeros(3)))))
            score = float(middle[0] if axis == 2 else middle[1])
            if best is None or score < best[0]:
                best = score, ends, out
        assert best is not None
        return best[1], best[2]

    def _mark(self, applied: Any) -> None:
        """Mark a wrench, and the point below it on the floor of the box."""
        place = self.box.inside(applied)
        if max(map(abs, place)) > 1:
            return
        held = any(piece.polyhedron.contains(applied) for piece in self.box.pieces)
        look: dict[str, Any] = {"lw": 0.5, "zorder": 5, "ls": (0, (1, 1.5)), "role": "line"}
        self.scene.line(self.at([place, [*place[:2], -1.0]]), ec=VERMILION, **look)
        sign, size, style = MARKS["resisted" if held else "refused"]
        self.scene.mark(self.at(place), sign, size, zorder=6, gid="wrench", **style)
