"""The strip below a picture: lines of text, keys in columns, and the bar of scale."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from arrangement.draw.colours import BLACK, VERMILION
from arrangement.draw.scene import POINTS, Scene, measure

from .keys import draw_symbol

_ROW, _SIDE, _KEY, _GAP, _BESIDE = (x * POINTS for x in (3.7, 3.0, 7.0, 3.0, 1.5))


@dataclass
class Legend:
    """Lines and keys, laid out in rows that fit a width in points.

    Attributes:
        bar: of scale: its length in points, and its label.
    """

    width: float
    lines: list[tuple[str, bool]] = field(default_factory=list)
    keys: list[tuple[str, str]] = field(default_factory=list)
    bar: tuple[float, str] | None = None

    def line(self, text: str, emphasis: bool = False) -> None:
        """Add a line of text; long ones are shortened."""
        self.lines.append((self._fitting(text, self.width - 2 * _SIDE), emphasis))

    def key(self, kind: str, text: str) -> None:
        """Add a key, its text shortened to a row; the kinds are those of `keys.draw_symbol`."""
        self.keys.append((kind, self._fitting(text, self.width - 2 * _SIDE - _KEY)))

    @staticmethod
    def _fitting(text: str, room: float) -> str:
        while len(text) > 8 and measure(text)[0] > room:
            text = text[:-2] + "…"
        return text

    @property
    def height(self) -> float:
        """The height of the strip in points."""
        return _ROW * (len(self.lines) + len(self._rows())) + 1.5 * POINTS

    def _rows(self) -> list[list[tuple[float, str, str]]]:
        """Return rows of (left end, kind, text), in columns unless that takes more rows."""
        items = [(kind, text, _KEY + measure(text)[0] + _GAP) for kind, text in self.keys]
        if self.bar is not None:
            length, text = self.bar
            items.append(("scale", text, length + _BESIDE + measure(text)[0] + _GAP))
        largest = max((size for *_, size in items), default=0.0)
        room = self.width - 2 * _SIDE + _GAP
        packed, columns = (_packed(items, room, least) for least in (0.0, largest))
        return columns if 2 * largest <= room and len(columns) <= len(packed) else packed

    def draw(self, scene: Scene) -> None:
        """Draw the strip at the bottom."""
        y = self.height - _ROW / 2
        for text, emphasis in self.lines:
            weight, colour = ("bold", VERMILION) if emphasis else ("normal", BLACK)
            _text(scene, _SIDE, y, text, weight=weight, color=colour)
            y -= _ROW
        for row in self._rows():
            for left, kind, text in row:
                if kind == "scale":
                    self._draw_bar(scene, left, y)
                else:
                    draw_symbol(scene, kind, left, y)
                    _text(scene, left + _KEY, y, text)
            y -= _ROW

    def _draw_bar(self, scene: Scene, left: float, y: float) -> None:
        assert self.bar is not None
        length, text = self.bar
        tick = 0.7 * POINTS
        style = {"ec": BLACK, "lw": 0.8}
        scene.line([(left, y), (left + length, y)], gid="scale", **style)
        for x in (left, left + length):
            scene.line([(x, y - tick), (x, y + tick)], **style)
        _text(scene, left + length + _BESIDE, y, text)


def _packed(
    items: Sequence[tuple[str, str, float]], room: float, least: float
) -> list[list[tuple[float, str, str]]]:
    """Return rows of items of at least some size: each goes to the first row with room for it."""
    rows: list[list[tuple[float, str, str]]] = []
    used: list[float] = []
    for kind, text, size in items:
        cell = max(size, least)
        row = next((i for i, left in enumerate(used) if left + cell <= room + 1e-6), len(rows))
        if row == len(rows):
            rows.append([])
            used.append(0.0)
        rows[row].append((_SIDE + used[row], kind, text))
        used[row] += cell
    return rows


def _text(scene: Scene, x: float, y: float, text: str, **style: Any) -> None:
    scene.text((x, y), text, ha="left", va="center_baseline", **style)
