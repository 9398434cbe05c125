"""Segments of the plane with the cells that their union bounds."""

from __future__ import annotations

import numpy as np

from arrangement.console.number_form import counted
from arrangement.drawing.colours import readable, side_colour
from arrangement.drawing.scene import POINTS, PageMap, Scene
from arrangement.drawing.views import picture
from arrangement.enumeration.subdivision import segment_sheet
from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.pictures.looks import (
    DASHES,
    ColoursOption,
    Look,
    NamesOption,
    read_looks,
    read_names,
)
from arrangement.pictures.names import swatch
from arrangement.segments import Segments

#: Room around the segments, in points.
_MARGIN = 6.0


@picture()
def draw_segments(
    segments: Segments,
    *,
    names: NamesOption | None = None,
    colours: ColoursOption | None = None,
    width: float = 88.0,
) -> Scene:
    """Draw segments of the plane, and the bounded cells between them by number of edges.

    Elements: ``edge-3`` for a segment, ``cell-5``, ``vertex-2``.

    Args:
        segments: one or more of them.
        names: of single segments, by number from 1 on, ``"1=ell,2=m"`` or ``{1: "ell"}``, beside
            their middles; if omitted, those of the segments.
        colours: of single segments by number or name, with a dash if need be, as for `draw_sphere`.

    Raises:
        InputError: there are none, or too many lines.
    """
    if not len(segments):
        raise InputError("there are no segments to draw; give one")
    import shapely

    if names is not None:
        segments = segments.named(read_names(names))
    looks = read_looks(colours or {}, segments, "segment")
    sheet = segment_sheet(segments.ends)
    budget.check_size(sheet.circles - 1, "great circles in a picture")
    ends = np.array([[[float(x) for x in p] for p in pair] for pair in segments.ends])
    low, high = ends.min(axis=(0, 1)), ends.max(axis=(0, 1))
    scene = Scene(width, 10.0)
    scale = (scene.width - 2 * _MARGIN) / max(high[0] - low[0], (high[1] - low[1]) / 1.2)
    height = 2 * _MARGIN + scale * float(high[1] - low[1])
    scene = Scene(width, height / POINTS)
    shift = np.array([scene.width, height]) / 2 - scale * (low + high) / 2
    scene.maps.append(PageMap(scale, (float(shift[0]), float(shift[1]))))
    parts: dict[int, list[object]] = {}
    for region, own in sheet.cell.items():
        if own not in sheet.open_cells:
            corners = sheet.sphere.incidence.origin[sheet.sphere.incidence.boundary(region)]
            outline = np.array([shift + scale * sheet.place(v) for v in corners.tolist()])
            parts.setdefault(own, []).append(shapely.Polygon(outline))
    areas = [(shapely.unary_union(polygons), own) for own, polygons in parts.items()]
    # A cell in a hole of another one comes after it.
    areas.sort(key=lambda cell: -shapely.Polygon(cell[0].exterior).area)
    for number, (area, own) in enumerate(areas, 1):
        fill = side_colour(sheet.edges[own])
        outline = shapely.get_coordinates(area.exterior)[:-1]
        scene.polygon(outline, fc=fill, ec="none", gid=f"cell-{number}")
    for number, pair in enumerate(ends, 1):
        colour, dash = looks.get(number - 1, Look("", ""))
        drawn = shift + scale * pair
        style = {"lw": 0.9, "ec": colour or "black", "ls": DASHES[dash or "solid"]}
        scene.line(drawn, zorder=3, gid=f"edge-{number}", **style)
        if segments.names and (text := segments.names[number - 1]):
            (x, y), middle = drawn[1] - drawn[0], drawn.mean(axis=0)
            beside = 5.0 * np.array([-y, x]) / np.hypot(x, y)
            scene.text(middle + beside, text, style="italic", color=readable(colour or "#000000"))
    for number, vertex in enumerate(np.flatnonzero(sheet.is_vertex).tolist(), 1):
        place = shift + scale * sheet.place(vertex)
        scene.circle(place, 1.2, fc="black", ec="none", zorder=4, gid=f"vertex-{number}")
    pieces = sheet.all_pieces()
    fills: dict[str, list[str]] = {}
    for edges in pieces.cells_by_edges:
        fills.setdefault(side_colour(edges), []).append(str(edges))
    for fill, texts in fills.items():
        scene.legend.key(swatch(fill, ec="black", lw=0.5), f"{', '.join(texts)} edges")
    numbers = counted(pieces.vertices, "vertex", "vertices"), counted(pieces.edges, "edge")
    scene.legend.line(f"{', '.join(numbers)}, {counted(pieces.bounded_cells, 'bounded cell')}")
    return scene
