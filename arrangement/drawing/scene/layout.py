"""The legend and the captions put below a picture, or to its right."""

from __future__ import annotations

import math
from typing import Any

from arrangement.drawing.colours import BLACK, VERMILION

from .items import moved
from .scene import POINTS, Key, Legend, Scene, measure, wrapped

#: The share of the width for a legend at the right, and of the height for keys and lines below.
BESIDE, BELOW = 0.32, 1 / 6
#: Sizes of letters that are tried, so that a legend takes no more than its share.
_SIZES = (7.0, 6.5, 6.0, 5.5, 5.0)
#: Space beside the legend, between a symbol and its text, and between keys, in points.
_SIDE, _BESIDE, _GAP = 8.5, 4.2, 8.5
_CAPTION, _TABLE = 6.0, 5.5
#: A row of keys as high as so many sizes of its letters, and the rows of the table in points.
_ROW, _TABLE_ROW = 1.45, 7.0


def picture_width(width: float, legend: str) -> float:
    """Return the width that the picture itself has on a sheet of a width."""
    return width * (1 - BESIDE) if legend == "right" else width


def laid_out(scene: Scene, legend: str = "below") -> Scene:
    """Return a sheet with a picture, its legend and its captions.

    Args:
        scene: the picture.
        legend: "below", in letters so small, from 7 to 5 points, that keys and lines take at most a
            sixth of the height; "right", in a strip that makes the sheet wider; or "none".
    """
    found = scene.legend
    strip = side = None
    paper = scene.width, scene.height
    if legend == "right":
        side = _strip(found, scene.width * BESIDE / (1 - BESIDE), _SIZES[0], scene.height)
    elif legend == "below":
        for size in _SIZES:
            strip = _strip(found, scene.width, size, min(paper))
            rest = _strip(Legend(found.lines, found.keys), scene.width, size, 0.0)
            table = strip.height - rest.height
            if strip.height - table <= BELOW * (scene.height + strip.height - table):
                break
    width = scene.width + (side.width if side else 0.0)
    captions = _captions(found.captions, width)
    below = captions.height + (strip.height if strip else 0.0)
    height = below + max(scene.height, side.height if side else 0.0)
    sheet = Scene(width / POINTS, height / POINTS)
    sheet.place(scene, 0.0, height - scene.height)
    if strip:
        sheet.place(strip, 0.0, captions.height)
    if side:
        sheet.place(side, scene.width, below + (height - below - side.height) / 2)
    sheet.place(captions, 0.0, 0.0)
    sheet.legend = Legend()
    return sheet


def _captions(texts: list[str], width: float) -> Scene:
    """Return lines of text that fit a width in points, in the middle."""
    room = width - 2 * _SIDE
    lines = [line for text in texts for line in wrapped(text, room, _CAPTION)]
    height = (_CAPTION + 2.0) * len(lines) + 3.0 * bool(lines)
    scene = Scene(width / POINTS, height / POINTS)
    for k, line in enumerate(lines):
        at = (width / 2, height - (_CAPTION + 2.0) * (k + 0.5))
        scene.text(at, line, _CAPTION, va="center_baseline")
    return scene


def _strip(legend: Legend, width: float, size: float, highest: float) -> Scene:
    """Return the legend as wide as given, its block of keys and lines in the middle.

    The table is left out, and a note says so, where it would be higher than `highest`.
    """
    room, row = width - 2 * _SIDE, _ROW * size
    first, last = (
        [
            part
            for text, strong in legend.lines
            if strong == which
            for part in wrapped(text, room, size)
        ]
        for which in (True, False)
    )
    rows = _rows(legend, room, size)
    table = _table(legend.table, room)
    if len(table) * _TABLE_ROW > highest > 0:
        table = [["regions in the order of Arrangement.regions(): their table would fill the page"]]
        table = [[line] for line in wrapped(table[0][0], room, _TABLE)]
    heights = [max(1, *(len(texts) for _, _, texts in cells)) for cells in rows]
    count = len(first) + sum(heights) + len(last)
    height = row * count + _TABLE_ROW * len(table) + 4.0 * bool(count or table)
    scene = Scene(width / POINTS, height / POINTS)
    ends = [max(_end(cell, size) for cell in cells) for cells in rows]
    used = max([*(measure(text, size)[0] for text in [*first, *last]), *ends], default=0.0)
    left, y = (width - used) / 2, height - 2.0

    def start(length: float) -> float:
        """Return where a row begins: several rows of keys have one left end."""
        return left if len(rows) > 1 else (width - length) / 2

    for text in first:
        at = start(measure(text, size)[0]), y - row / 2
        _write(scene, at, text, size, weight="bold", color=VERMILION)
        y -= row
    for cells, lines, end in zip(rows, heights, ends, strict=True):
        for x, key, texts in cells:
            x += start(end)
            scene.items += [moved(item, x, y - row / 2) for item in key.symbol]
            for k, text in enumerate(texts):
                at = (x + key.width + _BESIDE, y - row * (k + 0.5))
                _write(scene, at, text, size, color=BLACK)
        y -= row * lines
    for text in last:
        _write(scene, (start(measure(text, size)[0]), y - row / 2), text, size, color=BLACK)
        y -= row
    column = room / max(map(len, table), default=1)
    for k, entries in enumerate(table):
        for j, text in enumerate(entries):
            _write(scene, (_SIDE + column * j, y - _TABLE_ROW * (k + 0.5)), text, _TABLE)
    return scene


#: A key at its left end, with its text in lines.
_Cell = tuple[float, Key, list[str]]


def _end(cell: _Cell, size: float) -> float:
    left, key, texts = cell
    return left + key.width + _BESIDE + max(measure(text, size)[0] for text in texts)


def _rows(legend: Legend, room: float, size: float) -> list[list[_Cell]]:
    """Return rows of keys, in columns unless that takes more rows."""
    cells = [(0.0, key, wrapped(key.text, room - key.width - _BESIDE, size)) for key in legend.keys]
    widths = [_end(cell, size) + _GAP for cell in cells]
    packed, columns = (
        _packed(cells, [max(width, least) for width in widths], room + _GAP)
        for least in (0.0, max(widths, default=0.0))
    )
    return columns if len(columns) <= len(packed) else packed


def _packed(cells: list[_Cell], widths: list[float], room: float) -> list[list[_Cell]]:
    """Return rows of cells: each goes to the first row with room for it."""
    rows: list[list[_Cell]] = []
    used: list[float] = []
    for (_, key, texts), width in zip(cells, widths, strict=True):
        i = next((i for i, left in enumerate(used) if left + width <= room + 1e-6), len(rows))
        if i == len(rows):
            rows.append([])
            used.append(0.0)
        rows[i].append((used[i], key, texts))
        used[i] += width
    return rows


def _table(entries: list[str], room: float) -> list[list[str]]:
    """Return texts in rows, column by column in order."""
    widest = max((measure(text, _TABLE)[0] for text in entries), default=0.0) + _GAP
    columns = max(1, min(len(entries), math.floor(room / widest)))
    count = math.ceil(len(entries) / columns)
    return [entries[k::count] for k in range(count)]


def _write(scene: Scene, at: tuple[float, float], text: str, size: float, **style: Any) -> None:
    scene.text(at, text, size, ha="left", va="center_baseline", **style)
