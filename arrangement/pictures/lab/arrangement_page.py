"""The page of an arrangement: the arrangement lab without dragging.

Great circles and dual turn together, planes come and go. The page counts by itself, exactly, as the
lab does, also in real number fields; floats place curves on the screen.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.console.number_form import counted
from arrangement.drawing.pages import BASE_SCRIPT, BASE_STYLE, Template, floats, one_page, own
from arrangement.drawing.solids.sight import picture_axes, unit, unit_vectors
from arrangement.drawing.views import Vector
from arrangement.errors import refusal
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, shown
from arrangement.pictures.coordinates import (
    CHOICES,
    RANKS,
    caption,
    even_map,
    in_view_space,
    is_narrow,
    symmetric_map,
)
from arrangement.pictures.globe import Globe, clear_direction
from arrangement.pictures.looks import ColoursOption, looks_of_classes, read_looks
from arrangement.pictures.names import generator_text

_OWN = "arrangement.pictures.lab"
_LAB = ("circles", "cells", "words", "ball_view")
SCRIPTS: tuple[Template, ...] = (
    BASE_SCRIPT,
    *((_OWN, f"{name}.js") for name in ("rational", "vectors", "algebraic")),
    *map(own, ("dual.js", "ball.js", "turning.js")),
    *((_OWN, f"{name}.js") for name in ("links", *_LAB, "sphere")),
)
#: After the point, of what is drawn.
_DIGITS = 8
COLOURINGS = ("sides", "signs", "parity", "none")


def arrangement_page(
    arrangement: Arrangement,
    *,
    title: str | None = None,
    colour: str | None = None,
    camera: Vector | None = None,
    coordinates: str | None = None,
    colours: ColoursOption | None = None,
) -> str:
    """Build a self-contained HTML page for central planes in R^3.

    It shows the regions on the sphere and the dual (polyhedron, polygon or segment), which turn
    together. What lies under the pointer lights up in both, with its sign vector and an exact
    point. Planes can be taken away and put back.

    Args:
        arrangement: central, of rank at most 3, up to 40 distinct planes.
        title: a heading; if omitted, the number of planes.
        colour: of the regions at first: "sides" (by number of sides), "signs" (by number of minus
            signs), "parity" (two colours), "none"; if omitted, sides if they differ, else parity.
        camera: the exact first direction towards the viewer; if omitted, a clear one.
        coordinates: at first: "given"; "symmetric", after a linear map that shows the symmetry of
            the planes; "even", after one that spreads the normals evenly. If omitted, symmetric
            where that differs, but for planes of motions, and even where they are nearly parallel.
        colours: as for `draw_sphere`; a page has no dashes.

    Raises:
        InputError: another space, planes off the origin, too many planes, unknown colouring.
    """
    if colour is not None and colour not in COLOURINGS:
        raise refusal(f"the colouring is {shown(colour)}", colour, COLOURINGS)
    summary = _summary(arrangement)
    looks = looks_of_classes(arrangement, read_looks(colours or {}, arrangement))
    tints = {k: look.colour for k, look in looks.items() if look.colour}
    arrangement = in_view_space(arrangement, "arrangement", RANKS["sphere"])
    budget.check_size(len(arrangement.distinct), "great circles on a page")
    if coordinates is not None and coordinates not in CHOICES:
        raise refusal(f"the coordinates are {shown(coordinates)}", coordinates, CHOICES)
    globe = Globe(arrangement, camera)
    number = counted(len(arrangement), "plane")
    heading = title if title is not None else f"Arrangement of {number}"
    document = arrangement.to_dict()
    data = {
        "title": heading,
        "summary": summary,
        "colour": colour,
        "axes": floats(globe.axes, _DIGITS),
        "even": _symmetric_or_even(globe, arrangement, coordinates, camera),
        "planes": document["planes"],
        "names": arrangement.names or None,
        "tints": tints,
        "field": document.get("field"),
    }
    return one_page(
        heading,
        (_OWN, "sphere.html"),
        [BASE_STYLE, (_OWN, "cells.css"), (_OWN, "sphere.css")],
        SCRIPTS,
        data,
        ["spin", "home", "theme", "print"],
    )


def _symmetric_or_even(
    globe: Globe, arrangement: Arrangement, coordinates: str | None, direction: Vector | None
) -> dict[str, Any] | None:
    """Return what the page needs to show the planes symmetric, else evened out; None below rank 3.

    Args:
        coordinates: those at first; None: the symmetric ones, or nearly parallel planes evened out.
    """
    sphere = globe.whole
    if sphere.rank < 3:
        return None
    units = np.array([_unit(normal) for normal in sphere.circle_normals])
    symmetric = None if coordinates == "even" else symmetric_map(arrangement)
    for_normals = even_map(units) if symmetric is None else symmetric
    for_points = np.linalg.inv(for_normals).T
    rays = np.array([_unit(sphere.ray(v)) for v in range(sphere.vertex_count)]) @ for_points.T
    lines = _integers(np.concatenate([units @ for_normals.T, rays]))
    towards = _integers(np.array([_unit(globe.direction)]) @ for_points.T)[0]
    ahead = clear_direction(lines) if direction is None else towards
    at_first = coordinates in ("symmetric", "even")
    if coordinates is None and not arrangement.axes:
        at_first = is_narrow(units) or symmetric is not None
    return {
        "normals": floats(for_normals, _DIGITS),
        "points": floats(for_points, _DIGITS),
        "axes": floats(picture_axes(ahead), _DIGITS),
        "name": "evened out" if symmetric is None else "symmetric",
        "at_first": at_first,
    }


def _integers(vectors: Any) -> list[IntegerVector]:
    """Return vectors near multiples of some floats."""
    return [tuple(row) for row in np.rint(unit(vectors) * 10**6).astype(int).tolist()]


def _summary(arrangement: Arrangement) -> str:
    number, distinct = len(arrangement), len(arrangement.distinct)
    planes = f"{counted(number, 'plane')} through the origin"
    same = f", {distinct} of them distinct" if distinct < number else ""
    facts = (f"{planes}{same}", f"rank {arrangement.rank}", caption(arrangement, 3))
    return "; ".join(filter(None, (*facts, generator_text(arrangement))))


def _unit(vector: IntegerVector) -> list[float]:
    """Return a unit vector; the zero vector stays."""
    entries: list[float] = floats(unit_vectors([vector])[0], _DIGITS)
    return entries
