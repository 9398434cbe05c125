"""All cells of an arrangement in a cube or a ball, apart: a picture, and a page to turn.

Each cell moves away from the centre by the same multiple of the way to its own middle. Planes keep
the cells apart after that: for x in a cell with middle c beyond a plane, ``n . x`` and ``n . c`` are
both beyond, so ``n . (x + t c)`` is too, of the plane moved likewise. So the order of painting is
that of the cells in place, and exact (see `painting`).
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.exact import shown, to_text
from arrangement.polyhedra.cells import Cell, Cells, cut_cells

from .colours import SKIN, DrawnRegion, Painter, fill_colour, painter, pale
from .disc import plane_names
from .essential import brought, caption, shown_as
from .exploded_cells import Lifted
from .figure import picture
from .globe import view_direction
from .models import centroid
from .page import equation
from .painting import Stage, edges_of, unit_points, walls_of_edges
from .planenames import Names
from .planes import painter_of_facets
from .planesheet import PlanesSheet
from .registry import Exact, Vector
from .scene import Floats, Scene, checked_width
from .solid_page import Branch, Face, SolidPage
from .view_direction import clear_sight

#: More cells are no picture, and no page, any more.
MOST = 400


@picture
@shown_as("cells")
def draw_cells(
    arrangement: Arrangement,
    *,
    body: str = "cube",
    centre: Vector | None = None,
    radius: Exact | None = None,
    explode: float = 1.5,
    direction: Vector | None = None,
    labels: bool = True,
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
        centre, radius: exact, of the body, instead of one that contains all vertices.
        explode: by how much the middles of the cells are farther apart than in place; at least 1.
        direction: exact, towards the viewer; if omitted, one in which no plane is edge-on.
        labels: write sign vectors.
        width: of the figure, in millimetres.

    Raises:
        InputError: rank above 3, too many planes or cells, unknown body, a bad factor.
        MissingExtraError: matplotlib is absent.
    """
    width = checked_width(width)
    cells = _cells(arrangement, body, centre, radius, explode)
    towards = clear_sight(cells) if direction is None else view_direction(direction)
    stage = Stage(cells, towards)
    lifted = []
    for cell in cells.cells:
        shift = _middle(stage.points, cell) * (explode - 1)
        lifted.append(Lifted(cell, stage.points + shift, shift))
    sheet = PlanesSheet(stage, lifted, painter_of_facets("planes"), width)
    if labels:
        Names(sheet).name_cells()
    return sheet.scene
