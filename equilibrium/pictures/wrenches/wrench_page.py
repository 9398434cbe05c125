"""The resisted wrenches in space as an interactive page and as a 3D-printable model."""

from __future__ import annotations

import math
from fractions import Fraction

from arrangement.console.number_form import counted
from arrangement.drawing.pages.solid_page import PageFace, SolidPage, page_face
from arrangement.drawing.registry import Exact
from arrangement.drawing.solids.meshes import ClosedSurface, model_bytes
from arrangement.drawing.solids.sight import picture_axes
from arrangement.drawing.solids.surface import Patch, rounded
from arrangement.errors import InputError
from arrangement.numbers.exact import IntegerVector, number_text, primitive
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.model.labels import AS_ROUNDED
from equilibrium.pictures.parts.panel import read_extent
from equilibrium.pictures.parts.style import Wrench

from .wrench_box import CUT, NAMES, SOLID, WALLS, WrenchBox, box_edges, box_text, wrench_box


def wrench_set_page(
    grasp: Grasp,
    *,
    wrench: Wrench | None = None,
    extent: Exact | None = None,
    title: str | None = None,
) -> str:
    """Build a self-contained HTML page: the resisted wrenches as a solid, to rotate.

    Under the pointer a face shows its exact condition.

    Args:
        grasp: contacts.
        wrench: marked.
        extent: half the sides of the box, about the origin, as for the picture.
        title: a heading; if omitted, the number of contacts.

    Raises:
        GraspError: an extent that is not above 0.
    """
    box = wrench_box(grasp, read_extent(extent))
    number_of = grasp.size_words
    pieces: dict[IntegerVector, int] = {}
    told: list[tuple[str, list[tuple[str, str]]]] = []

    def face(patch: Patch) -> PageFace:
        wall = patch.row in WALLS
        if any(patch.row) and patch.row not in pieces:
            pieces[patch.row] = len(told)
            told.append(_told(box, patch, wall))
        number, faint = pieces.get(patch.row, -1), wall or patch.name == "axis"
        return page_face(patch, CUT if wall else SOLID, number, sheet=patch.sheet, faint=faint)

    zero = box.inside((Fraction(0),) * 3)
    marks = [
        ([1.1 if j == k else x for j, x in enumerate(zero)], name) for k, name in enumerate(NAMES)
    ]
    if wrench is not None:
        applied = read_wrench(wrench)
        held = any(piece.polyhedron.contains(applied) for piece in box.pieces)
        place = box.inside(applied)
        marks.append((place, "●" if held else "✕"))
    return SolidPage(
        title if title is not None else f"Wrenches that {number_of} resist",
        box_text(grasp, box),
        f"{counted(len(box.shapes), 'polyhedron', 'polyhedra')}, one for each choice of contact "
        "states that is not a part of another" + (f"; {AS_ROUNDED}" if grasp.data_error else ""),
        picture_axes(box.clear_side),
        math.sqrt(3),
        [node.drawn_as(face) for node in box.tree],
        told,
        [(SOLID, "where resistance ends"), (CUT, "cut by the box, goes on")],
        [ends for ends, _ in box_edges()],
        marks,
    ).text()


def _told(box: WrenchBox, patch: Patch, wall: bool) -> tuple[str, list[tuple[str, str]]]:
    """Return what the page says of a face: its condition on wrenches."""
    *normal, offset = patch.row
    row = [Fraction(a) / h for a, h in zip(normal, box.half, strict=True)]
    scaled = primitive([*row, -offset + sum(a * m for a, m in zip(row, box.middle, strict=True))])
    left = " ".join(
        f"{'-' if a < 0 else '+'} {'' if abs(a) == 1 else f'{number_text(abs(a))} '}{name}"
        for a, name in zip(scaled, NAMES, strict=False)
        if a
    ).removeprefix("+ ")
    name = (
        "Wall of the box" if wall else "Flat part of the set" if patch.sheet else "Face of the set"
    )
    return name, [("condition", f"{left} {'=' if patch.sheet else '≤'} {number_text(scaled[3])}")]


def wrench_set_model(
    grasp: Grasp, suffix: str, *, extent: Exact | None = None, size: float = 60.0
) -> bytes:
    """Build the resisted wrenches in a box as a model: one closed part for each polyhedron.

    Parts overlap where several equilibria exist. f_x, f_y and tau are x, y and z, each scaled so
    that the box is a cube. Parts are named by the contact states.

    Args:
        grasp: contacts.
        suffix: ``.stl``, ``.glb`` or ``.obj``.
        extent: half the sides of the box, about the origin, as for the picture.
        size: the longest side of the bounding box, in millimetres.

    Raises:
        GraspError: an extent that is not above 0.
        InputError: a set without volume.
    """
    box = wrench_box(grasp, read_extent(extent))
    half = size / 2
    parts = []
    for piece, shape in zip(box.pieces, box.shapes, strict=True):
        if shape.dimension == 3:
            walls = [tuple(-x for x in row) for row in WALLS]
            colours = tuple(CUT if row in walls else SOLID for row in shape.inequalities)
            points = half * rounded(shape.homogeneous[0])
            parts.append(
                ClosedSurface("-".join(piece.states) or "all", points, shape.cycles, colours)
            )
    if not parts:
        raise InputError(
            "the resisted wrenches have no volume; draw them as a picture: .svg, .pdf or .png"
        )
    return model_bytes(
        parts, suffix, f"resisted wrenches, {counted(len(parts), 'polyhedron', 'polyhedra')}"
    )
