"""The legend and the captions put below a picture, or to its right."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import accumulate
from typing import Any

from arrangement.console.progress import note
from arrangement.drawing.colours import BLACK, VERMILION
from arrangement.drawing.scene import (
    FONT,
    POINTS,
    Key,
    Legend,
    PageMap,
    Scene,
    measure,
    move_item,
    wrap_lines,
)
from arrangement.errors import InputError

#: The share of the width for a legend at the right, and of the height for keys and lines below.
BESIDE, BELOW = 0.32, 1 / 6
#: Sizes of letters that are tried, so that a legend takes no more than its share.
_SIZES = (7.0, 6.5, 6.0, 5.5, 5.0)
#: Space beside the legend, between a symbol and its text, and between keys, in points.
_SIDE, _BESIDE, _GAP = 8.5, 4.2, 8.5
_CAPTION, _TABLE = 6.0, 5.5
#: A row of keys as high as this many text sizes, and the rows of the table in points.
_ROW, _TABLE_ROW = 1.45, 7.0
#: Between panels, in millimetres; so two of 88 mm fill a page of 180 mm.
APART = 4.0


def picture_width(width: float, legend: str) -> float:
    """Return the width that the picture itself has on a sheet of a width."""
    return width * (1 - BESIDE) if legend == "right" else width


def lay_out(scene: Scene, legend: str = "below") -> Scene:
    """Return a sheet with a picture, its legend and its captions.

    Args:
        scene: the picture.
        legend: "below", in text so small, from 7 to 5 points, that keys and lines take at most a
            sixth of the height; "right", in a strip that makes the sheet wider; or "none".
    """
    entries = scene.legend
    strip = side = None
    paper = scene.width, scene.height
    if legend == "right":
        side = _strip(entries, scene.width * BESIDE / (1 - BESIDE), _SIZES[0], scene.height)
    elif legend == "below":
        for size in _SIZES:
            strip = _strip(entries, scene.width, size, min(paper))
            rest = _strip(Legend(entries.lines, entries.keys), scene.width, size, 0.0)
            table = strip.height - rest.height
            if strip.height - table <= BELOW * (scene.height + strip.height - table):
                break
    width = scene.width + (side.width if side else 0.0)
    captions = _captions(entries.captions, width)
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


def panel_sheet(
    scenes: Sequence[Scene], columns: int = 2, titles: Sequence[str] | None = None
) -> Scene:
    """Return several pictures as panels of one sheet, row by row, with one legend.

    What the legends of all panels say, and symbols and numbers that mean the same wherever they
    occur, the common one says once. The rest, such as bars of different scales, and captions stand
    below their panel. The names of elements have the panel first: ``panel-2-region-3``.

    Args:
        titles: above the panels; if omitted, (a), (b), ...
    """
    if not isinstance(columns, int) or columns < 1 or (titles and len(titles) != len(scenes)):
        raise InputError("give at least one column, and as many titles as pictures")
    own = [scene.legend for scene in scenes]
    meanings: dict[str, set[str]] = {}
    widths: dict[str, set[float]] = {}
    for key in (key for legend in own for key in legend.keys):
        meanings.setdefault(repr(key.symbol), set()).add(key.text)
        widths.setdefault(key.text, set()).add(key.width)
    for entry in (entry for legend in own for entry in legend.table):
        meanings.setdefault(entry.split()[0], set()).add(entry.strip())
    numbers = {entry.split()[0]: entry for legend in own for entry in legend.table}
    same = all(len(meanings[number]) == 1 for number in numbers)

    whole, panels = Legend(), []
    whole.notes = list(dict.fromkeys(text for legend in own for text in legend.notes))
    for legend, scene in zip(own, scenes, strict=True):
        rest = Legend(captions=legend.captions)
        for key in legend.keys:
            same_key = len(meanings[repr(key.symbol)]) == len(widths[key.text]) == 1
            (whole if same_key else rest).keys.append(key)
        for line in legend.lines:
            (whole if all(line in other.lines for other in own) else rest).lines.append(line)
        rest.table = [] if same else legend.table
        panel = Scene(*scene.paper)
        panel.place(scene, 0.0, 0.0)
        panel.maps = panel.maps or [PageMap()]
        panel.legend = rest
        panels.append(lay_out(panel))
    unique = {(repr(key.symbol), key.text): key for key in whole.keys}
    whole.keys, whole.lines = list(unique.values()), list(dict.fromkeys(whole.lines))
    if same:
        whole.table = [numbers[k] for k in sorted(numbers, key=lambda k: (len(k), k))]
    names = [f"({chr(97 + k)})" for k in range(len(panels))] if titles is None else titles
    above, gap = 1.5 * FONT * any(names), APART * POINTS
    rows = [range(k, min(k + columns, len(panels))) for k in range(0, len(panels), columns)]
    wide = [max(p.width for p in panels[j::columns]) for j in range(min(columns, len(panels)))]
    high = [max(panels[k].height for k in row) + above for row in rows]
    lefts, tops = ([0.0, *accumulate(size + gap for size in sizes)] for sizes in (wide, high))
    sheet = Scene((lefts[-1] - gap) / POINTS, (tops[-1] - gap) / POINTS)
    for k, panel in enumerate(panels):
        i, j = divmod(k, columns)
        panel.items = [replace(x, name=x.name and f"panel-{k + 1}-{x.name}") for x in panel.items]
        top = sheet.height - tops[i] - above
        lower = (high[i] - above - panel.height) / 2  # beside a higher one
        sheet.place(panel, lefts[j] + (wide[j] - panel.width) / 2, top - lower - panel.height)
        at = (lefts[j] + 2.0, top + above / 2)
        for title in names[k : k + 1]:
            sheet.text(at, title, ha="left", weight="bold", gid=f"panel-{k + 1}", role="label")
    sheet.legend = whole
    return sheet


def _captions(texts: list[str], width: float) -> Scene:
    """Return lines of text that fit a width in points, in the middle."""
    room = width - 2 * _SIDE
    lines = [line for text in texts for line in wrap_lines(text, room, _CAPTION)]
    height = (_CAPTION + 2.0) * len(lines) + 3.0 * bool(lines)
    scene = Scene(width / POINTS, height / POINTS)
    for k, line in enumerate(lines):
        at = (width / 2, height - (_CAPTION + 2.0) * (k + 0.5))
        scene.text(at, line, _CAPTION, va="center_baseline")
    return scene


def _strip(legend: Legend, width: float, size: float, highest: float) -> Scene:
    """Return the legend as wide as given, its block of keys and lines in the middle.

    The table is left out, and a note on stderr says so, where it would be higher than `highest`.
    """
    room, row = width - 2 * _SIDE, _ROW * size
    first, last = (
        [
            (part, measure(part, size, weight=weight)[0])
            for text, strong in legend.lines
            if strong == (weight == "bold")
            for part in wrap_lines(text, room, size, weight)
        ]
        for weight in ("bold", "normal")
    )
    rows = _rows(legend, room, size)
    table = _table(legend.table, room)
    if len(table) * _TABLE_ROW > highest > 0:
        note(f"a table of {len(legend.table)} sign vectors would fill the page and is left out")
        table = []
    heights = [max(1, *(len(texts) for _, _, texts in cells)) for cells in rows]
    count = len(first) + sum(heights) + len(last)
    height = row * count + _TABLE_ROW * len(table) + 4.0 * bool(count or table)
    scene = Scene(width / POINTS, height / POINTS)
    ends = [max(_end(cell, size) for cell in cells) for cells in rows]
    used = max([*(length for _, length in [*first, *last]), *ends], default=0.0)
    left, y = (width - used) / 2, height - 2.0

    def start(length: float) -> float:
        """Return where a row begins: several rows of keys have one left end."""
        return left if len(rows) > 1 else (width - length) / 2

    for text, length in first:
        at = start(length), y - row / 2
        _write(scene, at, text, size, weight="bold", color=VERMILION)
        y -= row
    for cells, lines, end in zip(rows, heights, ends, strict=True):
        for x, key, texts in cells:
            x += start(end)
            scene.items += [move_item(item, x, y - row / 2) for item in key.symbol]
            for k, text in enumerate(texts):
                at = (x + key.width + _BESIDE, y - row * (k + 0.5))
                _write(scene, at, text, size, color=BLACK)
        y -= row * lines
    for text, length in last:
        _write(scene, (start(length), y - row / 2), text, size, color=BLACK)
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
    cells = [
        (0.0, key, wrap_lines(key.text, room - key.width - _BESIDE, size)) for key in legend.keys
    ]
    widths = [_end(cell, size) + _GAP for cell in cells]
    packed, columns = (
        _pack(cells, [max(width, least) for width in widths], room + _GAP)
        for least in (0.0, max(widths, default=0.0))
    )
    return columns if len(columns) <= len(packed) else packed


def _pack(cells: list[_Cell], widths: list[float], room: float) -> list[list[_Cell]]:
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
