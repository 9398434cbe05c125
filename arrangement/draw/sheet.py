"""A sheet of paper measured in points, on which no label covers another or leaves the sheet."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
import numpy.typing as npt

from arrangement.errors import InputError
from arrangement.exact import shown

from .output import millimetres, require_matplotlib

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Floats: TypeAlias = npt.NDArray[np.float64]
#: A point of the sheet.
Place: TypeAlias = Sequence[float] | Floats
#: Left, bottom, right, top; in points.
Box: TypeAlias = tuple[float, float, float, float]

#: Millimetres to points.
POINTS = 72 / 25.4
#: Resolution at which text is measured; pictures are saved with the same.
DPI = 300
_CORNERS = ((-1, -1), (1, -1), (1, 1), (-1, 1))
#: Least distance between two labels, and of a label from the border; in points.
GAP = 0.8


class Sheet:
    """A figure with one coordinate system: points (1/72 inch) from the lower left corner.

    Attributes:
        figure: the matplotlib figure.
        axes: its only axes, as large as the figure.
        width, height: in points.
        boxes: what is covered by labels so far.
    """

    def __init__(self, width: float, height: float) -> None:
        """Take width and height in millimetres."""
        require_matplotlib()
        from matplotlib.backends import backend_agg
        from matplotlib.figure import Figure

        self.width, self.height = width * POINTS, height * POINTS
        self.figure: Figure = Figure(figsize=(width / 25.4, height / 25.4), dpi=DPI)
        self.axes: Any = self.figure.add_axes((0.0, 0.0, 1.0, 1.0))
        self.axes.set(xlim=(0, self.width), ylim=(0, self.height))
        self.axes.set_axis_off()
        self.boxes: list[Box] = []
        renderer: Any = backend_agg.RendererAgg
        self._renderer = renderer(10, 10, DPI)
        self._sizes: dict[tuple[str, float, float], tuple[float, float]] = {}

    def measure(self, text: str, size: float, rotation: float = 0.0) -> tuple[float, float]:
        """Return the width and height of a text, in points."""
        key = (text, size, rotation)
        if key not in self._sizes:
            from matplotlib.text import Text

            label = Text(0, 0, text, size=size, rotation=rotation, linespacing=1.0)
            label.set_figure(self.figure)
            extent = label.get_window_extent(self._renderer)
            self._sizes[key] = (extent.width * 72 / DPI, extent.height * 72 / DPI)
        return self._sizes[key]

    def box(self, at: Place, text: str, size: float, rotation: float = 0.0) -> Box:
        """Return the box of a text centred at a point."""
        w, h = self.measure(text, size, rotation)
        return (at[0] - w / 2, at[1] - h / 2, at[0] + w / 2, at[1] + h / 2)

    def is_free(self, box: Box) -> bool:
        """Whether a box is on the sheet and covers no label."""
        left, bottom, right, top = box
        if left < GAP or bottom < GAP or right > self.width - GAP or top > self.height - GAP:
            return False
        return not any(
            left < r + GAP and right > l - GAP and bottom < t + GAP and top > b - GAP
            for l, b, r, t in self.boxes  # noqa: E741
        )

    def write(
        self,
        at: Place,
        text: str,
        size: float = 7.0,
        *,
        anchor: tuple[float, float] = (0.5, 0.5),
        rotation: float = 0.0,
        **style: Any,
    ) -> bool:
        """Write a text if its place is free; return whether it was.

        Args:
            at: a point of the sheet.
            text: one or several lines.
            size: in points.
            anchor: the point of the text that is put there: (0, 0) its lower left corner,
                (1, 1) its upper right one.
            rotation: in degrees.
            style: goes to matplotlib.
        """
        w, h = self.measure(text, size, rotation)
        x, y = at[0] + (0.5 - anchor[0]) * w, at[1] + (0.5 - anchor[1]) * h
        box = (x - w / 2, y - h / 2, x + w / 2, y + h / 2)
        if not self.is_free(box):
            return False
        self.boxes.append(box)
        self.axes.text(
            x, y, text, size=size, ha="center", va="center", rotation=rotation, linespacing=1.0,
            **{"zorder": 6, **style},
        )  # fmt: skip
        return True

    def curve(self, points: Floats, **style: Any) -> None:
        """Draw control points (3k + 1, 2) of cubic curves, joined."""
        from matplotlib.patches import PathPatch
        from matplotlib.path import Path

        codes = [Path.MOVETO] + [Path.CURVE4] * (len(points) - 1)
        self.axes.add_patch(PathPatch(Path(points, codes), **style))

    def circle(self, centre: Place, radius: float, **style: Any) -> Any:
        """Draw a circle; return it, for instance to clip others."""
        from matplotlib.patches import Circle

        return self.axes.add_patch(Circle((centre[0], centre[1]), radius, **style))

    def marker(self, at: Place, size: float, shape: str, **style: Any) -> None:
        """Draw a small disc ("round") or square ("square") of about the same area."""
        if shape == "round":
            self.circle(at, size, **style)
            return
        half = size * 0.9
        corners = [(at[0] + x * half, at[1] + y * half) for x, y in _CORNERS]
        self.polygon(corners, **style)

    def polygon(self, corners: Any, **style: Any) -> None:
        """Draw a closed polygon."""
        from matplotlib.patches import Polygon

        self.axes.add_patch(Polygon(np.asarray(corners), closed=True, **style))

    def line(self, points: Any, **style: Any) -> None:
        """Draw an open polygonal line."""
        from matplotlib.patches import PathPatch
        from matplotlib.path import Path

        self.axes.add_patch(PathPatch(Path(np.asarray(points)), fill=False, **style))

    def keys(
        self, y: float, keys: Iterable[tuple[str, dict[str, Any]]], size: float = 7.0
    ) -> float:
        """Write a legend in rows centred under `y`; return the height that it takes.

        A key is a text with the style of a patch, or of a line if the style has "line".
        """
        entries = [(text, style, 15 + self.measure(text, size)[0]) for text, style in keys]
        rows: list[list[tuple[str, dict[str, Any], float]]] = [[]]
        for entry in entries:
            if rows[-1] and sum(e[2] + 9 for e in [*rows[-1], entry]) - 9 > self.width - 6:
                rows.append([])
            rows[-1].append(entry)
        step = size + 3.5
        for k, row in enumerate(rows):
            x = (self.width - sum(e[2] + 9 for e in row) + 9) / 2
            centre = y - step * (k + 0.5)
            for text, style, length in row:
                self._key(x, centre, style)
                self.write((x + 15, centre), text, size, anchor=(0, 0.5))
                x += length + 9
        return step * len(rows) if entries else 0.0

    def _key(self, x: float, y: float, style: dict[str, Any]) -> None:
        if "line" in style:
            self.line([(x, y), (x + 12, y)], **style["line"])
        elif "marker" in style:
            shape = style["marker"]
            rest = {name: value for name, value in style.items() if name != "marker"}
            self.marker((x + 8, y), 2.8, shape, **{"ec": "black", **rest})
        else:
            corners = [(x + 2, y - 3.5), (x + 11, y - 3.5), (x + 11, y + 3.5), (x + 2, y + 3.5)]
            self.polygon(corners, **{"ec": "black", "lw": 0.5, **style})


def checked_width(width: object, least: float = 40.0) -> float:
    """Return a width in millimetres, or refuse it."""
    length = millimetres(width, "the width")
    if length < least:
        raise InputError(f"the width is {shown(width)}; give at least {least:g} millimetres")
    return length
