"""The strip below a picture: lines of text, keys in columns, and the bar of scale."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from arrangement.draw.colours import BLACK, VERMILION
from arrangement.draw.scene import POINTS, Scene, measure

from .keys import draw_symbol

_ROW, _SIDE, _KEY, _GAP = (x * POINTS for x in (3.7, 3.0, 7.0, 3.0))


@dataclass
class Legend:
    """Lines and keys, laid out in rows that fit a width in points; `scaled`: with a bar."""

    width: float
    scaled: bool = False
    lines: list[tuple[str, bool]] = field(default_factory=list)
    keys: list[tuple[str, str]] = field(default_factory=list)

    def line(self, text: str, emphasis: bool = False) -> None:
        """Add a line of text; long ones are shortened."""
        while len(text) > 8 and measure(text)[0] > self.width - 2 * _SIDE:
            text = text[:-2] + "…"
        self.lines.append((text, emphasis))

    def key(self, kind: str, text: str) -> None:
        """Add a key; the kinds are those of `keys.draw_symbol`."""
        self.keys.append((kind, text))

    @property
    def height(self) -> float:
        """The height of the strip in points."""
        return _ROW * (len(self.lines) + len(self._rows()) + self.scaled) + 1.5 * POINTS

    def _rows(self) -> list[list[tuple[float, str, str]]]:
        """Return rows of (left end, kind, text), in columns where at least two of them fit."""
        sizes = [_KEY + measure(text)[0] + _GAP for _, text in self.keys]
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

    def draw(self, scene: Scene, scale: tuple[float, str] | None = None) -> None:
        """Draw the strip at the bottom; `scale` is a length in points and its label."""
        y = self.height - _ROW / 2
        for text, emphasis in self.lines:
            weight, colour = ("bold", VERMILION) if emphasis else ("normal", BLACK)
            _text(scene, _SIDE, y, text, weight=weight, color=colour)
            y -= _ROW
        for row in self._rows():
            for left, kind, text in row:
                draw_symbol(scene, kind, left, y)
                _text(scene, left + _KEY, y, text)
            y -= _ROW
        if scale is not None:
            length, text = scale
            tick = 0.7 * POINTS
            style = {"ec": BLACK, "lw": 0.8}
            scene.line([(_SIDE, y), (_SIDE + length, y)], gid="scale", **style)
            for x in (_SIDE, _SIDE + length):
                scene.line([(x, y - tick), (x, y + tick)], **style)
            _text(scene, _SIDE + length + 1.5 * POINTS, y, text)


def _text(scene: Scene, x: float, y: float, text: str, **style: Any) -> None:
    scene.text((x, y), text, ha="left", va="center_baseline", **style)
