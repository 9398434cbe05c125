"""All cells of an arrangement in a cube or a ball, apart: a picture, a page, a model.

Each cell moves away from the centre by the same multiple of the way to its own middle. Planes keep
the cells apart after that: if x and the middle c of a cell are beyond a plane ``n . x = b``, then
``x + t c`` is beyond ``n . x = (1 + t) b``. So the order of painting is that of the cells in place,
and exact (see `depth_tree`).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.console.number_form import EXACT, LABEL, counted
from arrangement.console.progress import note
from arrangement.drawing.colours import (
    PAINTERS,
    SKIN,
    DrawnRegion,
    Painter,
    painter_of,
    pale,
    plane_colour,
)
from arrangement.drawing.pages import PageFace, SolidPage
from arrangement.drawing.scene import Floats, PageMap, Scene, millimetres
from arrangement.drawing.solids.depth_tree import plane_tree
from arrangement.drawing.solids.meshes import ClosedSurface, model_bytes, triangles
from arrangement.drawing.solids.sight import picture_axes, turn_view, view_direction
from arrangement.drawing.views import Exact, Vector
from arrangement.duals.cells import Cell, Cells, cut_cells
from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.numbers.exact import shown, sign_text
from arrangement.numbers.linear.rank import cycle_edges
from arrangement.pictures.coordinates import (
    caption,
    in_coordinates,
    in_view_space,
    planes_view,
)
from arrangement.pictures.looks import ColoursOption, looks_of_classes, read_looks
from arrangement.pictures.names import Labels, RegionLabels, equation, generator_text, plane_names
from arrangement.pictures.planes import PlanesSheet
from arrangement.pictures.stage import (
    Lifted,
    Stage,
    StagedAxes,
    clear_sight,
    sharp,
    unit_points,
    walls_of_edges,
)
from arrangement.planes.planes import Names, Planes

#: Up to this many cells have labels.
_NAMED = 60


@planes_view("cells")
def draw_cells(
    arrangement: Arrangement,
    *,
    body: str = "cube",
    centre: Vector | None = None,
    radius: Exact | None = None,
    explode: float = 1.5,
    camera: Vector | None = None,
    azimuth: float = 0.0,
    labels: Labels | None = None,
    coordinates: str | None = None,
    width: float = 88.0,
) -> Scene:
    """Draw the cells of planes in R^3, cut off by a cube or a ball, as solids that stand apart.

    A wall has the colour of its plane, what the body cuts is bare. Sign vectors stand on the cells
    where they fit. Cells are painted back to front in an exact order.

    Elements: ``cell-++-``, one for each visible face.

    Args:
        arrangement: of rank at most 3, central or not, coincident planes allowed; in another space
            than R^3 its essentialisation.
        body: "cube" or "ball".
        centre, radius: exact place and size of the body, if it is not to contain all vertices.
        explode: by how much the middles of the cells are farther apart than in place; at least 1.
        camera: exact vector to the viewer; if omitted, one in which no plane is edge-on.
        azimuth: as for `draw_sphere`.
        labels: labels of cells, as for `draw_sphere`, on faces that have room; none for more than
            60 cells if omitted.
        coordinates: of central planes, as for `draw_planes`.

    Raises:
        InputError: rank above 3, too many planes or cells, unknown body, a bad factor.
    """
    if coordinates is None and not (centre is None and radius is None):
        coordinates = "given"
    arrangement, camera, moved = in_coordinates(coordinates, arrangement, camera)
    cells = _cells(arrangement, body, centre, radius, explode)
    towards = clear_sight(cells) if camera is None else view_direction(camera)
    stage = Stage(cells, turn_view(towards, azimuth))
    lifted = []
    for cell in cells.cells:
        shift = centroid(stage.points, cell.faces) * (explode - 1)
        lifted.append(Lifted(cell, stage.points + shift, shift))
    names = RegionLabels(arrangement, labels, len(lifted), _NAMED)
    signs = [cell.signs for cell in cells.cells]
    axes = StagedAxes(stage, ())
    sheet = PlanesSheet(stage, lifted, lambda x: plane_colour(x.label), width, axes, apart=True)
    left = 0 if names.kind == "none" else sheet.name_cells(names, outside=False)
    legend = sheet.scene.legend
    names.explain(legend, signs)
    if left and names.requested:
        note(f"{left} of {len(lifted)} cells are hidden or too narrow for a label")
    shifts = {item.cell.signs: item.shift for item in lifted}

    def place(point: Floats) -> Floats:
        seen = stage.in_view(moved(point))
        return sheet.place(seen + shifts[stage.cell_of(seen).signs])

    sheet.scene.maps.append(PageMap(place=place, size=3))
    return sheet.scene


def cells_page(
    arrangement: Arrangement,
    *,
    title: str | None = None,
    colours: ColoursOption | None = None,
    centre: Vector | None = None,
    radius: Exact | None = None,
    explode: float = 1.3,
    camera: Vector | None = None,
) -> str:
    """Build a self-contained HTML page: the cells of planes in R^3, in a cube, to rotate.

    They can be moved apart. A cell under the pointer shows its sign vector, its planes, whether it
    is bounded, and an exact point.

    Args:
        arrangement: of rank at most 3, central or not.
        title: a heading; if omitted, the number of planes.
        colours: as for `draw_sphere`; a page has no dashes.
        centre, radius: exact, of the cube, instead of one that contains all vertices.
        explode: how far the cells stand apart at first, from 1 to 3.
        camera: exact vector to the viewer at first; if omitted, one in which no plane is edge-on.

    Raises:
        InputError: rank above 3, too many planes or cells, a bad factor.
    """
    number = counted(len(arrangement), "plane")
    note, fills = caption(arrangement, 3), _fills(arrangement, colours)
    arrangement = in_view_space(arrangement, "cells")
    cells = _cells(arrangement, "cube", centre, radius, explode)
    towards = clear_sight(cells) if camera is None else view_direction(camera)
    points = unit_points(cells)
    faces: list[tuple[tuple[int, ...], PageFace]] = []
    facts_of_cells = []
    regions = {face.signs: face for face in arrangement.regions()}
    firsts = arrangement.distinct_planes
    for k, cell in enumerate(cells.cells):
        faces += [(cell.sides, face) for face in _faces(points, cell, k, fills)]
        walls = sorted({wall for wall in cell.walls if wall >= 0})
        sign = sign_text(cell.signs, "\u2212")
        planes = "; ".join(equation(firsts[w][:3], firsts[w][3]) for w in walls)
        whole = "whole" if len(walls) == len(set(cell.walls)) else "cut off"
        point = EXACT.vector(regions[cell.signs].witness)
        facts = [("planes", planes or "none"), ("a point", point), ("in the cube", whole)]
        facts_of_cells.append((sign or "all", facts))
    legend = [
        (
            fills[label],
            f"{plane_names(arrangement, members)}: {equation(first[:3], first[3])}",
        )
        for label, (members, first) in enumerate(zip(arrangement.distinct, firsts, strict=True))
    ]
    body = cells.body
    summary = (f"{number}, rank {arrangement.rank}", note, generator_text(arrangement))
    return SolidPage(
        title if title is not None else f"Cells of {number}",
        "; ".join(filter(None, summary)),
        f"{len(cells.cells)} cells in a cube with centre {LABEL.vector(body.centre)} and edge "
        f"{float(2 * body.radius):.4g}",
        picture_axes(towards),
        3**0.5,
        plane_tree(firsts, faces),
        facts_of_cells,
        [*legend, (SKIN, "cut by the cube")],
        apart=float(explode),
    ).text()


def _cells(
    arrangement: Arrangement, body: str, centre: Vector | None, radius: Exact | None, explode: float
) -> Cells:
    """Return the cells in a body, or refuse the request."""
    if not isinstance(explode, int | float) or not 1 <= explode <= 3:
        raise InputError(f"explode is {shown(explode)}; give a factor from 1 to 3")
    cells = cut_cells(arrangement, body, centre, radius)
    budget.check_size(len(cells.cells), "cells in a picture", "a smaller radius shows fewer")
    return cells


def _fills(planes: Planes, colours: str | Names | None) -> list[str]:
    """Return the colour of the walls on each class of planes."""
    own = looks_of_classes(planes, read_looks(colours or {}, planes))
    chosen = (own[first].colour if first in own else "" for first in planes.firsts)
    return [colour or pale(plane_colour(k)) for k, colour in enumerate(chosen)]


def _faces(points: Floats, cell: Cell, number: int, fills: Sequence[str]) -> list[PageFace]:
    middle, walls = centroid(points, cell.faces), walls_of_edges(cell)
    faces = []
    for face, wall in zip(cell.faces, cell.walls, strict=True):
        corners = points[list(face)]
        edges = [points[[a, b]] for a, b in cycle_edges(face) if sharp(*walls[a, b], smooth=False)]
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        fill = SKIN if wall < 0 else fills[wall]
        lines = np.array(edges).reshape(-1, 2, 3)
        faces.append(PageFace(corners, fill, normal, lines, number, middle))
    return faces


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
    colours: ColoursOption | None = None,
    coordinates: str | None = None,
) -> bytes:
    """Build all cells of an arrangement in a ball or a cube as separate closed parts.

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
        centre, radius: exact place and size of the body; see `body_around`.
        explode: at least 1; with 1 the parts stay together.
        size: the longest side of the bounding box, in millimetres, before parts move.
        colour: colours in GLB: "planes" (a wall has the colour of its plane), "sides" (a cell by
            its number of walls), "signs" (by its number of minus signs), "none", or a function of
            a `DrawnRegion`.
        colours: as for `draw_sphere`; walls have the colours of their planes.
        coordinates: as for `draw_planes`.

    Raises:
        InputError: another space, too many planes, a bad option.
        ArrangementError: a cell is too thin for single precision; with vertices far apart, choose
            a smaller radius.
    """
    if not isinstance(explode, int | float) or not 1 <= explode <= 10:
        raise InputError(f"explode is {shown(explode)}; give a factor from 1 to 10")
    paint = None if colour == "planes" else painter_of(colour, PAINTERS)
    if colours is not None and paint is not None:
        raise InputError("colours of single planes go with the colour planes; keep one of them")
    fills = _fills(arrangement, colours)
    half = millimetres(size, "size") / 2
    if coordinates is None and not (centre is None and radius is None):
        coordinates = "given"
    arrangement, *_ = in_coordinates(coordinates, in_view_space(arrangement, "cells"))
    cells = cut_cells(arrangement, body, centre, radius)
    points = unit_points(cells) * half
    parts = [_part(cells, cell, points, explode - 1, paint or fills) for cell in cells.cells]
    kind = counted(len(parts), "cell")
    return model_bytes(parts, suffix, f"{kind} of an arrangement in a {body}")


def _part(
    cells: Cells, cell: Cell, points: Floats, apart: float, paint: Painter | list[str]
) -> ClosedSurface:
    used = sorted({i for face in cell.faces for i in face})
    number = {old: new for new, old in enumerate(used)}
    own = points[used]
    faces = tuple(tuple(number[i] for i in face) for face in cell.faces)
    walls = {wall for wall in cell.walls if wall >= 0}
    if isinstance(paint, list):
        colours = tuple(paint[w] if w >= 0 else SKIN for w in cell.walls)
    else:
        colours = (paint(DrawnRegion(cell.signs, len(walls))),) * len(faces)
    middle = centroid(own, faces) * apart
    text = sign_text(cell.signs)
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
