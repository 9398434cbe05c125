"""One square picture of a plane of wrenches: axes with numbers, a region, its border, a fade."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np

from arrangement.draw.output import require_matplotlib
from arrangement.exact import RationalVector
from equilibrium.solver.state_system import States
from equilibrium.wrench_sets import Region

from .body import Floats
from .shapes import text_size
from .style import BLACK, FILLS, FONT, GREY, SHADE, SYMBOLS, VERMILION, bare, nice, points, rounded
from .window import Window, area, roomiest

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Space in millimetres beside and below a panel, for numbers and names of the axes.
LEFT, BELOW, ABOVE = 12.0, 9.0, 5.0
HATCH = "//////"
_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_FADE = 0.16


@dataclass
class Panel:
    """A square with paper coordinates from -1 to 1 for a window.

    Args:
        figure: where it stands.
        corner: left and lower end in millimetres.
        side: its length in millimetres.
        size: width and height of the figure in millimetres.
        name: a prefix for the names of its elements.
    """

    figure: Figure
    window: Window
    corner: tuple[float, float]
    side: float
    size: tuple[float, float]
    name: str = ""
    axes: Any = field(init=False)
    unit: float = field(init=False)

    def __post_init__(self) -> None:
        (x, y), (wide, high) = self.corner, self.size
        self.axes = self.figure.add_axes((x / wide, y / high, self.side / wide, self.side / high))
        bare(self.axes, (-1.0, -1.0), (1.0, 1.0))
        self.unit = 2 / points(self.side)

    def gid(self, kind: str, index: int) -> str:
        """Return the name of an element."""
        return f"{self.name}{kind}-{index}"

    def rulers(
        self, names: Sequence[str], unit: str = "", *, left: bool = True, below: bool = True
    ) -> None:
        """Draw lines through the origin, and numbers and names at the left and lower edges.

        A power of ten goes to the names where the numbers would be long.
        """
        zero = self.window.paper((Fraction(0), Fraction(0)))
        for k, at in enumerate(zero):
            if abs(at) < 1:
                ends = np.array([[at, -1.0], [at, 1.0]])[:, :: -1 if k else 1]
                self.axes.plot(*ends.T, color=GREY, lw=0.4, zorder=1.5)
        half, power = rounded(self.window.half), 0
        if half and math.isfinite(half):
            power = math.floor(math.log10(half))
            power = power if not -3 < power < 4 else 0
            for k, wanted in enumerate((below, left)):
                if wanted:
                    self._numbers(k, nice(0.6 * half), Fraction(10) ** power)
        factor = f"10{str(power).translate(_RAISED)}" if power else ""
        note = f" ({' '.join(filter(None, (factor, unit)))})" if factor or unit else ""
        style = {"size": FONT, "ha": "center", "va": "center"}
        if below:
            self.axes.text(0, -1 - 19 * self.unit, names[0] + note, **style)
        if left:
            place = -1 - 26 * self.unit
            self.axes.text(place, 0, names[1] + note, rotation=90, **style)

    def _numbers(self, k: int, step: Fraction, factor: Fraction) -> None:
        low, high = (self.window.centre[k] + side * self.window.half for side in (-1, 1))
        edge = -1 - 2 * self.unit
        for i in range(math.ceil(low / step), math.floor(high / step) + 1):
            at = float((i * step - self.window.centre[k]) / self.window.half)
            text = f"{float(i * step / factor):g}".replace("-", "−")
            if k == 0 and abs(at) + text_size(text, self.unit)[0] / 2 > 1 + 5 * self.unit:
                continue
            place, tick = ((at, edge), (at, -1.0)) if k == 0 else ((edge, at), (-1.0, at))
            self.axes.plot(*np.array([place, tick]).T, color=GREY, lw=0.4, clip_on=False)
            shift = np.array([(0, -6), (-2, 0)][k]) * self.unit
            self.axes.text(*(np.array(place) + shift), text, size=FONT, clip_on=False,
                           ha="center" if k == 0 else "right", va="center")  # fmt: skip

    def title(self, text: str, above: float = 5.0, **style: Any) -> None:
        """Write a title above, from the left edge; its middle is so many points above the top."""
        place = 1 + above * self.unit
        self.axes.text(-1, place, text, size=FONT, ha="left", va="center", **style)

    def region(self, region: Region, by_states: bool = True) -> None:
        """Fill the polygons, small ones on top, and draw the outline of their union."""
        parts = []
        for i, piece in enumerate(region.polygons):
            shape = self.window.inside(piece.polyhedron)
            if shape is not None:
                parts.append((area(shape), i, shape, piece.states))
        parts.sort(key=lambda part: (-part[0], part[1]))
        for _, i, shape, states in parts:
            self._piece(i, shape, states, by_states)
        if by_states:
            self._codes([(shape, states) for size, _, shape, states in parts if size])
        self._outline(region)

    def _piece(self, index: int, shape: Floats, states: States, by_states: bool) -> None:
        gid, fill = self.gid("polygon", index), fill_of(states) if by_states else SHADE
        thin = GREY if by_states else SHADE
        if len(shape) == 1:
            self.axes.plot(*shape.T, "o", ms=2, color=thin, gid=gid, zorder=1.2)
        elif len(shape) == 2:
            self.axes.plot(*shape.T, color=thin, lw=0.6, gid=gid, zorder=1.2)
        else:
            line = {"ec": "#404040", "lw": 0.4} if by_states else {"ec": fill, "lw": 0.5}
            self.polygon(shape, fc=fill, gid=gid, zorder=1, **line)
            if by_states and "detached" in states:
                self.polygon(shape, fc="none", ec="#7d7d7d", lw=0, hatch=HATCH, zorder=1)

    def polygon(self, shape: Floats, **style: Any) -> None:
        """Add a filled polygon on paper; hatch lines are thin."""
        from matplotlib.patches import Polygon

        with require_matplotlib().rc_context({"hatch.linewidth": 0.35}):
            self.axes.add_patch(Polygon(shape, closed=True, joinstyle="bevel", **style))

    def _codes(self, parts: Sequence[tuple[Floats, States]]) -> None:
        """Write the states into the polygons where they fit and nothing later covers them."""
        from matplotlib.path import Path

        paths = [Path(shape) for shape, _ in parts]
        for i, (shape, states) in enumerate(parts):
            text = code(states)
            wide, high = text_size(text, self.unit)
            half = (wide / 2 + 1.5 * self.unit, high / 2 + 0.5 * self.unit)
            place, room = roomiest(shape, half, 1 - _FADE)
            box = [place + np.array([a * half[0], b * half[1]])
                   for a in (-1, 0, 1) for b in (-1, 0, 1)]  # fmt: skip
            covered = any(path.contains_points(box).any() for path in paths[i + 1 :])
            if text and room > 1 and not covered:
                plate = {"boxstyle": "square,pad=0.12", "fc": fill_of(states), "ec": "none"}
                self.axes.text(*place, text, size=FONT, ha="center", va="center_baseline",
                               zorder=1.6, bbox=plate, gid=self.gid("code", i))  # fmt: skip

    def _outline(self, region: Region) -> None:
        outline = region.outline
        for kind, segments in (("border", outline.border), ("whisker", outline.whiskers)):
            for i, segment in enumerate(segments):
                found = self.window.stretch(segment)
                if found is not None:
                    self.axes.plot(*found[0].T, color=BLACK, lw=1.3, gid=self.gid(kind, i),
                                   zorder=2, solid_capstyle="round")  # fmt: skip
        for i, point in enumerate(outline.points):
            self.axes.plot(*self.window.paper(point)[:, None], "o", ms=3.5, color=BLACK,
                           gid=self.gid("point", i), zorder=3)  # fmt: skip

    def fade(self) -> None:
        """Let what reaches the edge go pale: it has no end."""
        from matplotlib.patches import PathPatch
        from matplotlib.path import Path

        rings = 12
        square = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]])
        codes = [Path.MOVETO, *[Path.LINETO] * 3, Path.CLOSEPOLY]
        for k in range(rings):
            inner = 1 - _FADE * (rings - k) / rings
            ring = Path(np.concatenate([1.01 * square, inner * square[::-1]]), codes * 2)
            self.axes.add_patch(PathPatch(ring, fc="white", ec="none", alpha=0.16, zorder=4))

    def wrench(self, point: RationalVector, resisted: bool) -> None:
        """Mark a wrench: a full disc when it is resisted, a cross when not."""
        style = {"color": VERMILION, "zorder": 6, "gid": f"{self.name}wrench"}
        place = self.window.paper(point)[:, None]
        if resisted:
            self.axes.plot(*place, "o", ms=5, mec="white", mew=0.7, **style)
        else:
            self.axes.plot(*place, "x", ms=5.5, mew=1.6, **style)


def fill_of(states: States) -> str:
    """Return the colour of a choice of states, by the number of sticking contacts."""
    return FILLS[min(states.count("stick"), len(FILLS) - 1)]


def code(states: States) -> str:
    """Return the states of all contacts as one character each."""
    return "\u200a".join(SYMBOLS[state] for state in states)
