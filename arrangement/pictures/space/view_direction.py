"""A direction of view in which no plane is edge-on and few things coincide by accident."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from arrangement.drawing.scene.items import Floats
from arrangement.drawing.solids.sight import best_view, unit, unit_vectors, views
from arrangement.duals.cells import Cells
from arrangement.numbers.exact import IntegerVector, primitive, unoriented

from .stage import unit_points

#: Pairs of lines that are compared at most; the rest of a large arrangement hardly matters.
_MOST_PAIRS = 400


def clear_sight(cells: Cells, lifted: Sequence[tuple[int, ...]] = ()) -> IntegerVector:
    """Return a direction from above that shows the planes well.

    It avoids planes seen edge-on or from straight ahead. Less strictly, it avoids directions in
    which two planes are seen at the same angle, or two of these lines fall together: intersections
    of planes, axes, diagonals of a cube.
    Lifted cells move sideways in the picture, a little towards the viewer. The choice is one of a
    fixed list, so that it is exact and repeats.
    """
    found = views(range(-7, 8), range(-7, 8), range(1, 6), low=0.25, high=0.62)
    return best_view(found, lambda seen: _score(unit_vectors(seen), cells, lifted))


def _score(units: Floats, cells: Cells, lifted: Sequence[tuple[int, ...]]) -> Floats:
    normals = [plane[:3] for plane in cells.arrangement.integer_planes]
    score = np.ones(len(units))
    if normals:
        facing = np.abs(units @ unit_vectors(normals).T)
        oblique = np.minimum(facing, 0.8 * np.sqrt(np.maximum(0.0, 1 - facing**2)))
        score = np.minimum(score, oblique.min(axis=1))
        pairs = list(combinations(unit_vectors(normals), 2))[:_MOST_PAIRS]
        # From the planes of symmetry between two of the planes, and those through two lines.
        score = np.minimum(score, 2 * _apart(units, [m for a, b in pairs for m in (a - b, a + b)]))
    pairs = list(combinations(unit_vectors(_lines(cells, normals)), 2))[:_MOST_PAIRS]
    score = np.minimum(score, 3 * _apart(units, [np.cross(a, b) for a, b in pairs]))
    for way in _ways(cells, lifted):
        towards = units @ way
        score *= np.exp(-(((towards - 0.3) / 0.35) ** 2))
    found: Floats = score * (1 + 0.02 * units[:, 0] - 0.05 * units[:, 1])
    return found


def _lines(cells: Cells, normals: Sequence[IntegerVector]) -> list[IntegerVector]:
    """Return the directions of intersections of planes, the axes, and the diagonals of a cube."""
    # Of entries short enough for machine integers.
    small = [n for n in normals if max(map(abs, n)) < 2**30]
    crosses = {unoriented(primitive(np.cross(a, b).tolist())) for a, b in combinations(small, 2)}
    fixed = {(1, 0, 0), (0, 1, 0), (0, 0, 1)}
    if cells.body.kind == "cube":
        fixed |= {(1, 1, 1), (1, 1, -1), (1, -1, 1), (-1, 1, 1)}
    return sorted(line for line in crosses | fixed if any(line))


def _apart(units: Floats, normals: Sequence[Floats]) -> Floats:
    """Return how far each view is from planes; normals of length 0 do not count."""
    rows = np.array(normals).reshape(-1, 3)
    lengths = np.linalg.norm(rows, axis=1)
    rows = rows[lengths > 1e-6] / lengths[lengths > 1e-6, None]
    apart: Floats = np.abs(units @ rows.T).min(axis=1, initial=1.0)
    return apart


def _ways(cells: Cells, lifted: Sequence[tuple[int, ...]]) -> Floats:
    """Return the unit directions from the centre to the lifted cells."""
    points = unit_points(cells)
    chosen = [cell.faces for cell in cells.cells if cell.signs in lifted]
    middles = [points[sorted({i for face in faces for i in face})].mean(axis=0) for faces in chosen]
    return unit(np.array([way for way in middles if np.linalg.norm(way) > 1e-9]).reshape(-1, 3))
