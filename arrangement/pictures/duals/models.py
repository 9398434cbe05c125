"""Models to hold, as the bytes of STL, GLB and OBJ files: the dual polyhedron, and the cells."""

from __future__ import annotations

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.console.number_form import counted
from arrangement.drawing.colours import (
    SKIN,
    DrawnRegion,
    Painter,
    fill_colour,
    painter,
    pale,
    side_colour,
)
from arrangement.drawing.output import millimetres
from arrangement.drawing.registry import Exact, Vector
from arrangement.drawing.solids.meshes import ClosedSurface, Floats, model_bytes, triangles
from arrangement.duals.cells import Cell, Cells, cut_cells
from arrangement.duals.zonohedron import dual_polyhedron
from arrangement.duals.zonohedron.polyhedron import content
from arrangement.errors import InputError
from arrangement.numbers.exact import shown
from arrangement.pictures.essential import brought
from arrangement.pictures.space.painting import unit_points
from arrangement.pictures.sphere.coordinates import in_coordinates

from .solids import unit_lengths


def dual_model(
    arrangement: Arrangement, suffix: str, *, size: float = 60.0, coordinates: str = "given"
) -> bytes:
    """Return the dual polyhedron as a file; see `DualPolyhedron.export`.

    In GLB a face is coloured by its number of corners.

    Args:
        arrangement: central, of rank 3; in another space than R^3 its essentialisation.
        suffix: ``.stl``, ``.glb`` or ``.obj``.
        size: the largest side of the bounding box, in millimetres.
        coordinates: "given"; or "symmetric" or "even" as for `draw_dual`, with generators of
            length 1.
    """
    arrangement, _ = in_coordinates(coordinates, brought(arrangement, "dual"))
    lengths = None if coordinates == "given" else unit_lengths(arrangement)
    dual = dual_polyhedron(arrangement, lengths)
    colours = tuple(side_colour(len(face)) for face in dual.faces)
    return content(dual, suffix, millimetres(size, "size"), colours)


def cells_model(
    arrangement: Arrangement,
    suffix: str,
    *,
    body: str = "ball",
    centre: Vector | None = None,
    radius: Exact | None = None,
    explode: float = 1.3,
    size: float = 60.0,
    colour: str | Painter = "planes",
    coordinates: str = "given",
) -> bytes:
    """Return all cells of an arrangement in a ball or a cube as separate closed parts.

    Every region of the arrangement meets the body (unless a smaller one is asked for), and gives
    one part. The parts are cut exactly and fit together without gaps; the ball is a polyhedron of
    5120 triangles. A part moves outward by ``explode - 1`` times the way from the centre of the
    body to its middle.

    STL has one closed shell for each part, OBJ one object, GLB one node. Objects and nodes are
    named by the sign vector.

    Args:
        arrangement: of rank at most 3, central or not, coincident planes allowed; in another space
            than R^3 its essentialisation.
        suffix: ``.stl``, ``.glb`` or ``.obj``.
        body: "ball" or "cube".
        centre, radius: exact, of the body; see `body_around`.
        explode: at least 1; with 1 the parts stay together.
        size: the diameter of the ball or the edge of the cube before the parts move, in
            millimetres.
        colour: in GLB. "planes" (a wall has the colour of its plane), "sides" (a cell by its
            number of walls), "signs" (by its number of minus signs), "none", or a function of a
            `DrawnRegion`.
        coordinates: of central planes: "given", "symmetric" or "even", as for `draw_planes`.

    Raises:
        InputError: another space, too many planes, a bad option.
        ArrangementError: a cell is too thin for single precision; with vertices far apart, choose
            a smaller radius.
    """
    if not isinstance(explode, int | float) or not 1 <= explode <= 10:
        raise InputError(f"explode is {shown(explode)}; give a factor from 1 to 10")
    paint = None if colour == "planes" else painter(colour)
    half = millimetres(size, "size") / 2
    arrangement, _ = in_coordinates(coordinates, brought(arrangement, "cells"))
    cells = cut_cells(arrangement, body, centre, radius)
    points = unit_points(cells) * half
    parts = [_part(cells, cell, points, explode - 1, paint) for cell in cells.cells]
    kind = counted(len(parts), "cell")
    return model_bytes(parts, suffix, f"{kind} of an arrangement in a {body}")


def _part(
    cells: Cells, cell: Cell, points: Floats, apart: float, paint: Painter | None
) -> ClosedSurface:
    used = sorted({i for face in cell.faces for i in face})
    number = {old: new for new, old in enumerate(used)}
    own = points[used]
    faces = tuple(tuple(number[i] for i in face) for face in cell.faces)
    walls = {wall for wall in cell.walls if wall >= 0}
    if paint is None:
        colours = tuple(pale(fill_colour(w)) if w >= 0 else SKIN for w in cell.walls)
    else:
        colours = (paint(DrawnRegion(cell.signs, len(walls))),) * len(faces)
    middle = centroid(own, faces) * apart
    text = "".join("+" if s > 0 else "-" for s in cell.signs)
    shift = (float(middle[0]), float(middle[1]), float(middle[2]))
    return ClosedSurface(text or "all", own, faces, colours, shift, {"signs": text})


def centroid(points: Floats, faces: tuple[tuple[int, ...], ...]) -> Floats:
    """Return the centre of mass of a closed surface of convex faces.

    Raises:
        InputError: it is flat in floats.
    """
    a, b, c = (points[column] for column in triangles(faces).T)
    volumes = np.einsum("ij,ij->i", a, np.cross(b, c))
    if abs(volumes.sum()) < 1e-12 * abs(points).max() ** 3:
        raise InputError("a cell is too thin for floats; try the coordinates even")
    middle: Floats = (volumes @ (a + b + c)) / (4 * volumes.sum())
    return middle
