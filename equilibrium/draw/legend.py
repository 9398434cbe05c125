"""The strip below a picture: lines of text, keys in columns, and the bar of scale."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from .shapes import arrow, mark, text_size, wedge
from .style import BLACK, BLUE, FONT, GREY, VERMILION, bare, points

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_ROW, _SIDE, _KEY, _GAP = 3.7, 3.0, 7.0, 3.0


@dataclass
class Legend:
    """Lines and keys, laid out in rows that fit a width in millimetres; `scaled`: with a bar."""

    width: float
    scaled: bool = False
    lines: list[tuple[str, bool]] = field(default_factory=list)
    keys: list[tuple[str, str]] = field(default_factory=list)

    def line(self, text: str, emphasis: bool = False) -> None:
        """Add a line of text; long ones are shortened."""
        while len(text) > 8 and _wide(text) > self.width - 2 * _SIDE:
            text = text[:-2] + "…"
        self.lines.append((text, emphasis))

    def key(self, kind: str, text: str) -> None:
        """Add a key: a kind of `_symbol`, or a fill ``#rrggbb`` with an optional hatch."""
        self.keys.append((kind, text))

    @property
    def height(self) -> float:
        """The height of the strip in millimetres."""
        return _ROW * (len(self.lines) + len(self._rows()) + self.scaled) + 1.5

    def _rows(self) -> list[list[tuple[float, str, str]]]:
        """Return rows of (left end, kind, text), in columns of equal width where they fit."""
        if not self.keys:
            return []
        cell = max(_KEY + _wide(text) + _GAP for _, text in self.keys)
        columns = max(1, int((self.width - 2 * _SIDE + _GAP) / cell))
        cells = [
            (_SIDE + (i % columns) * cell, kind, text) for i, (kind, text) in enumerate(self.keys)
        ]
        return [cells[i : i + columns] for i in range(0, len(cells), columns)]

    def draw(self, figure: Figure, scale: tuple[float, str] | None = None) -> None:
        """Draw the strip at the bottom; `scale` is a length in millimetres and its label."""
        total = figure.get_size_inches()[1] * 25.4
        axes = figure.add_axes((0.0, 0.0, 1.0, self.height / total))
        bare(axes, (0.0, 0.0), (self.width, self.height))
        y = self.height - _ROW / 2
        for text, emphasis in self.lines:
            axes.text(_SIDE, y, text, size=FONT, va="center_baseline",
                      weight="bold" if emphasis else "normal",
                      color=VERMILION if emphasis else BLACK)  # fmt: skip
            y -= _ROW
        for row in self._rows():
            for left, kind, text in row:
                _symbol(axes, kind, left, y)
                axes.text(left + _KEY, y, text, size=FONT, va="center_baseline")
            y -= _ROW
        if scale is not None:
            _bar(axes, y, *scale)


def _wide(text: str) -> float:
    return text_size(text, 1 / points(1.0))[0]


def _bar(axes: Any, y: float, length: float, text: str) -> None:
    ends = np.array([[_SIDE, y], [_SIDE + length, y]])
    axes.plot(*ends.T, color=BLACK, lw=0.8, gid="scale", solid_capstyle="butt")
    for x, _ in ends:
        axes.plot([x, x], [y - 0.7, y + 0.7], color=BLACK, lw=0.8)
    axes.text(_SIDE + length + 1.5, y, text, size=FONT, va="center_baseline")


def _symbol(axes: Any, kind: str, left: float, y: float) -> None:
    unit = 1 / points(1.0)
    start, end, middle = np.array([left, y]), np.array([left + 5.5, y]), np.array([left + 2.75, y])
    ahead = np.array([1.0, 0.0])
    if kind in ("force", "wrench"):
        colour = BLACK if kind == "force" else VERMILION
        axes.add_patch(arrow(start, end, unit, fc=colour, ec="none"))
    elif kind == "preload":
        axes.add_patch(arrow(start, end, 1.6 * unit, fc="white", ec=GREY, lw=0.7))
    elif kind == "cone":
        axes.add_patch(wedge(start, ahead, 0.3, 5.0, fc="#e69f0059", ec="#b87f00", lw=0.5))
    elif kind == "shift":
        axes.add_patch(arrow(start, end, unit, fc=BLUE, ec="none"))
    elif kind == "motion":
        axes.plot(*np.array([start, end]).T, color=BLUE, lw=0.9, ls=(0, (1, 1.5)))
    elif kind in ("stick", "slip", "detached"):
        state = "slip+" if kind == "slip" else kind
        axes.add_patch(mark(state, middle, ahead, 6.0 * unit, ec=BLACK, lw=0.8))
    elif kind in ("resisted", "refused"):
        shape = {"marker": "o", "ms": 5} if kind == "resisted" else {"marker": "x", "mew": 1.6}
        axes.plot([middle[0]], [y], color=VERMILION, **shape)
    elif kind == "wrench-points":
        axes.plot([left + 1.3], [y], color=VERMILION, marker="o", ms=5)
        axes.plot([left + 4.2], [y], color=VERMILION, marker="x", ms=5, mew=1.6)
    elif kind == "fade":
        for k in range(11):
            grey = f"#{round(160 + 9 * k):02x}" + f"{round(160 + 9 * k):02x}" * 2
            axes.plot([left + 0.5 * k, left + 0.5 * (k + 1)], [y, y], color=grey, lw=6,
                      solid_capstyle="butt")  # fmt: skip
    elif kind == "border":
        axes.plot(*np.array([start, end]).T, color=BLACK, lw=1.3)
    else:
        _swatch(axes, kind, left, y)


def _swatch(axes: Any, kind: str, left: float, y: float) -> None:
    """Draw a small field of a colour ``#rrggbb``, hatched when the word follows."""
    from matplotlib.patches import Rectangle

    fill, _, hatched = kind.partition(" ")
    axes.add_patch(Rectangle((left, y - 1.2), 5.5, 2.4, fc=fill, ec=GREY, lw=0.4))
    for k in range(5 if hatched else 0):
        x = left + 0.3 + 1.1 * k
        axes.plot([x, x + 0.8], [y - 1.2, y + 1.2], color="#4d4d4d", lw=0.35)
