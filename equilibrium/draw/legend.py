"""The strip below a picture: lines of text, keys in columns, and the bar of scale."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from .keys import draw_symbol
from .shapes import text_size
from .style import BLACK, FONT, VERMILION, bare, points

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
        """Add a key; the kinds are those of `keys.draw_symbol`."""
        self.keys.append((kind, text))

    @property
    def height(self) -> float:
        """The height of the strip in millimetres."""
        return _ROW * (len(self.lines) + len(self._rows()) + self.scaled) + 1.5

    def _rows(self) -> list[list[tuple[float, str, str]]]:
        """Return rows of (left end, kind, text), in columns where at least two of them fit."""
        sizes = [_KEY + _wide(text) + _GAP for _, text in self.keys]
        room = self.width - 2 * _SIDE + _GAP
        in_columns = 2 * max(sizes, default=0.0) <= room
        rows: list[list[tuple[float, str, str]]] = []
        left = room
        for (kind, text), size in zip(self.keys, sizes, strict=True):
            cell = max(sizes) if in_columns else size
            if left + cell > room + 1e-6:
                rows.append([])
                left = 0.0
            rows[-1].append((_SIDE + left, kind, text))
            left += cell
        return rows

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
                draw_symbol(axes, kind, left, y)
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
