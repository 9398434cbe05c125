"""The views with the planes that they show, and the space in which planes are drawn.

Planes of rank r in R^d are those of an arrangement in R^r, times a linear space. Most views are
made for one space, R^2, R^3 or R^4. This module brings planes there, says so below the picture, and
refuses what cannot be brought there by naming the views that can show it.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Concatenate, ParamSpec

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.counts.configuration import pivot_columns
from arrangement.drawing.registry import ViewEntry
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.scene.scene import Scene
from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, dot
from arrangement.numbers.linear.rank import rank, unit_vectors
from arrangement.planes.planes import Planes

P = ParamSpec("P")
RAISED = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
#: A linear map is rounded to multiples of 1 over this, or of a fraction of it.
_SCALE = 1 << 12


@dataclass(frozen=True)
class Ranks:
    """Which planes a view shows: those of ranks from `least` to `most`, or only central ones."""

    most: float = math.inf
    central: bool = False
    least: int = 0

    def __call__(self, planes: Planes) -> bool:
        """Return whether it shows planes."""
        in_range = self.least <= planes.rank <= self.most
        return in_range and (planes.is_central or not self.central)


_ALL = Ranks()
#: Where each view is, and which planes it shows.
VIEWS: Mapping[str, ViewEntry] = {
    "sphere": ViewEntry("sphere.sphere:draw_sphere", Ranks(3, central=True)),
    "planes": ViewEntry("space.planes:draw_planes", Ranks(3)),
    "cells": ViewEntry("space.cells:draw_cells", Ranks(3)),
    "lines": ViewEntry("diagrams.lines:draw_lines", Ranks(2)),
    "stereographic": ViewEntry("sphere.stereographic:draw_stereographic", Ranks(3, central=True)),
    "gnomonic": ViewEntry("sphere.gnomonic:draw_gnomonic", Ranks(3, central=True)),
    "dual": ViewEntry("duals.dual:draw_dual", Ranks(4, central=True)),
    "section": ViewEntry("space.planes:draw_section", Ranks(4, central=True, least=4)),
    "graph": ViewEntry("duals.graph:draw_graph", _ALL),
    "poset": ViewEntry("duals.poset:draw_poset", _ALL),
    "lattice": ViewEntry("diagrams.lattice:draw_lattice", _ALL),
}
MODELS: Mapping[str, ViewEntry] = {
    "dual": ViewEntry("duals.dual:dual_model", Ranks(4, central=True)),
    "cells": ViewEntry("space.cells:cells_model", Ranks(3)),
}
PAGES: Mapping[str, ViewEntry] = {
    "arrangement": ViewEntry("page.page:arrangement_page", Ranks(3, central=True)),
    "cells": ViewEntry("space.cells:cells_page", Ranks(3)),
}


def fits(view: str, planes: Planes) -> bool:
    """Return whether a view or page can show planes."""
    return {**PAGES, **VIEWS}[view].shows(planes)


def space(view: str, planes: Planes) -> int:
    """Return the dimension of the space in which a view draws planes."""
    flat = view == "lines" or (view == "graph" and not planes.is_central)
    return max(2 if flat else 3, planes.rank)


def suited(views: Mapping[str, ViewEntry], planes: Planes) -> dict[str, ViewEntry]:
    """Return views in the order in which they suit planes, those that cannot show them last."""

    first = "sphere" if planes.is_central else "cells"
    if planes.rank <= 2 and planes.dimension != 3:
        first = "lines"
    elif planes.rank > 3:
        first = "dual" if fits("dual", planes) else "lattice"

    def rank(name: str) -> tuple[bool, bool]:
        return not views[name].shows(planes), name != first

    return {name: views[name] for name in sorted(views, key=rank)}


def shown_as(
    name: str,
) -> Callable[
    [Callable[Concatenate[Arrangement, P], Scene]], Callable[Concatenate[Arrangement, P], Scene]
]:
    """Return a decorator: the view `name` draws planes of any space, with a caption.

    Raises:
        InputError: the view cannot show the planes; others that can are named.
    """

    def decorate(
        view: Callable[Concatenate[Arrangement, P], Scene],
    ) -> Callable[Concatenate[Arrangement, P], Scene]:
        @functools.wraps(view)
        def draw(arrangement: Arrangement, /, *args: P.args, **options: P.kwargs) -> Scene:
            scene = view(brought(arrangement, name), *args, **options)
            if text := caption(arrangement, space(name, arrangement)):
                scene.legend.captions.append(text)
            return scene

        return draw

    return decorate


def items_of(planes: Planes) -> str:
    """Return what hyperplanes are called in their space."""
    return {2: "lines", 3: "planes"}.get(planes.dimension, "hyperplanes")


def brought(arrangement: Arrangement, view: str) -> Arrangement:
    """Return planes in the space of a view.

    Raises:
        InputError: the view cannot show them.
    """
    budget.keep(len(arrangement), "planes in a picture")
    if not fits(view, arrangement):
        shown: Any = {**PAGES, **VIEWS}[view].shows
        kind = "central" if arrangement.is_central else "affine"
        others = [name for name in VIEWS if fits(name, arrangement)]
        raise InputError(
            f"{view} shows {'central ' * shown.central}planes of rank "
            f"{'at most ' * (not shown.least)}{shown.most}; these are {kind}, of rank "
            f"{arrangement.rank} in R^{arrangement.dimension}: "
            f"for them there are {', '.join(others)}"
        )
    return in_space(arrangement, space(view, arrangement))


def caption(planes: Planes, dimension: int) -> str:
    """Return what is said below a picture of planes in R^dimension; nothing in their own space."""
    if planes.dimension == dimension:
        return ""
    essential = "essentialisation of an " * (planes.dimension > planes.rank)
    space = f"arrangement in R{str(planes.dimension).translate(RAISED)}"
    return (
        f"{essential}{space}"
        + ("", ", times a line", ", times a plane", ", times R³")[dimension - planes.rank]
    )


def in_space(arrangement: Arrangement, dimension: int) -> Arrangement:
    """Return planes of rank r in R^n, n >= r, with the same signs, faces and offsets.

    The first r coordinates are orthonormal ones of the span of the normals, rounded: angles stay
    what they were but for less than 10^-3. The map is invertible, and applied exactly.

    >>> braid = Arrangement([[1, -1, 0, 0], [0, 1, -1, 0], [0, 0, 1, -1]])
    >>> in_space(braid, 3).rank
    3
    """
    if arrangement.dimension == dimension:
        return arrangement
    normals = [plane[:-1] for plane in arrangement.integer_planes]
    columns = pivot_columns(normals, arrangement.dimension)
    scale, rows = 1, unit_vectors(len(columns))
    if len(columns) < arrangement.dimension and columns:
        rows, scale = rounded_map(_isometry(normals, columns), _SCALE // 8)
    zeros = (0,) * (dimension - len(columns))
    chosen = ([normal[j] for j in columns] for normal in normals)
    return Arrangement(
        [(*(dot(row, normal) for row in rows), *zeros) for normal in chosen],
        [offset * scale for offset in arrangement.offsets],
        dimension=dimension,
    )


def _isometry(normals: Sequence[IntegerVector], columns: Sequence[int]) -> Floats:
    """Return the symmetric matrix that makes chosen coordinates of normals orthonormal ones."""
    largest = [max(map(abs, normal)) for normal in normals]
    scaled = [[x / most for x in n] for n, most in zip(normals, largest, strict=True)]
    span = np.linalg.svd(np.array(scaled), full_matrices=False)[2][: len(columns), columns]
    return inverse_root(span.T @ span)


def inverse_root(squares: Floats) -> Floats:
    """Return the inverse of the symmetric root of a matrix of sums of squares."""
    sizes, axes = np.linalg.eigh(squares)
    root: Floats = (axes / np.sqrt(np.maximum(sizes, 1e-12))) @ axes.T
    return root


def rounded_map(matrix: Floats, scale: int) -> tuple[list[IntegerVector], int]:
    """Return an invertible integer matrix that is nearly a float one times a scale, and the scale.

    Args:
        scale: times 8, or a higher power of 8 where rounding leaves no inverse.
    """
    rows: list[IntegerVector] = []
    while rank(rows) < len(matrix):
        scale *= 8
        rows = [tuple(round(x * scale) for x in row) for row in matrix.tolist()]
    return rows, scale
