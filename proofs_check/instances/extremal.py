"""Arrangements that are extreme in some count: most triangles, fewest simple vertices, few regions.

Random samples rarely meet them, so a bound that all samples keep may fail at one of them. They are
given by coordinates, and counted like every other arrangement.

Sources: Z. Fueredi and I. Palasti, Arrangements of lines with a large number of triangles,
Proceedings of the AMS 92 (1984); B. Green and T. Tao, On sets defining few ordinary lines,
Discrete and Computational Geometry 50 (2013), for the examples of Boeroeczky and the exceptions
with 7 and 13 lines to Dirac's bound on simple vertices; OEIS A006066 for Kobon's triangles.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.library import families
from arrangement.library.families.classical import golden_ratio

#: Largest number of lines of a family that has a member for each number.
MOST = 12
#: Lines a x + b y = c with 11, 21, 25, 32 and 37 bounded triangles; of 7 to 11 lines no more are
#: known, of 12 one more.
_KOBON: Sequence[Sequence[tuple[int, int, int]]] = (
    ((1, 0, 0), (0, 1, 0), (1, -1, 1), (1, -2, -1), (1, 1, -2), (2, -3, 1), (-1, 10, -4)),
    (
        *((-11, 28, 35), (-19, -23, 35), (30, -4, 35), (-1, 30, 55), (-25, -16, 55)),
        *((26, -14, 55), (2, -30, 23), (25, 17, 23), (-27, 13, 23)),
    ),
    (
        *((-79, -61, 49), (33, -94, 49), (100, 3, 49), (28, 96, 49), (-82, 57, 49)),
        *((-51, -86, -258), (66, -75, -258), (92, 39, -258), (-9, 100, -258), (-97, 22, -258)),
    ),
    (
        *((-29, -5, 5), (-310, -150, -79), (-11, -10, -10), (-95, -150, 8), (-45, -150, -83)),
        *((0, -5, 1), (45, -150, -2), (19, -30, 30), (165, -150, 104), (31, -15, 13)),
        (145, -25, 7),
    ),
    (
        *((-40, -4, 55), (23, -33, 55), (17, 36, 55), (-16, -37, -6), (40, 5, -6), (-24, 32, -6)),
        *((34, 21, 97), (-35, 19, 97), (1, -40, 97), (-18, -36, 55), (40, 2, 55), (-22, 34, 55)),
    ),
)
Rows = Sequence[Sequence[Any]]


def extremal() -> Iterator[tuple[str, Arrangement]]:
    """Yield names and arrangements: planes through the origin of R^3, and some as lines of R^2."""
    for m in range(4, MOST + 1):
        for part in (1, 3):
            yield from _both(f"fueredi_palasti({m}, {part})", fueredi_palasti(m, part))
    for rows in _KOBON:
        yield from _both(f"kobon({len(rows)})", [(a, b, -c) for a, b, c in rows])
    for m in range(11, MOST + 1):
        yield f"near_pencil({m})", families.near_pencil(m)
    for m in range(3, MOST + 1):
        parallels = [(1, 0, -k) for k in range(m - 1)]
        yield f"parallels({m}, d=2)", _lines([*parallels, (0, 1, 0)])
        yield f"near_pencil({m}, d=2)", _lines([*((1, k, 0) for k in range(m - 1)), (0, 1, -1)])
    for m in (7, 11):
        yield f"boeroeczky({m})", boeroeczky(m)


def extremal_irrational() -> Iterator[tuple[str, Arrangement]]:
    """Yield those with coefficients in Q(sqrt(5)), which not every function of a user can read."""
    yield from _both("regular(10)", regular_of_pentagon())
    yield "crowe_mckee(13)", crowe_mckee()


def fueredi_palasti(m: int, part: int = 1) -> list[tuple[int, int, int]]:
    """Return lines a x + b y + c = 0, no three through a point, with about m^2/3 triangles.

    Line k goes through the points of the unit circle at the angles u and pi - 2 u, u = 2 t, where
    t = (2 k + 1/part) pi / (2 m); its coordinates sin t, cos t, -sin 3t are rounded.
    """
    angles = [(2 * k + 1 / part) * math.pi / (2 * m) for k in range(m)]
    exact = [(math.sin(t), math.cos(t), -math.sin(3 * t)) for t in angles]
    return [(round(1000 * a), round(1000 * b), round(1000 * c)) for a, b, c in exact]


def boeroeczky(m: int) -> Arrangement:
    """Return 4k + 3 planes with few simple vertices: A(4k + 4, 1) without a mirror.

    For other numbers the example is A(2n, 1) or A(4k + 1, 1) itself, which is simplicial.
    """
    normals = families.regular(m + 1).normals
    middle = len(normals) // 2  # the first mirror
    return Arrangement([*normals[:middle], *normals[middle + 1 :]])


def crowe_mckee() -> Arrangement:
    """Return 13 planes with 6 simple vertices, dual to points over Q(sqrt(5)).

    The points are the corners of two regular pentagons with a common side, the middle of this side,
    and those at infinity of the side, its mirror and two diagonals; the x-axis is stretched.
    """
    g, h = golden_ratio()
    corners = [(1, g, 1), (1, -g, 1), (g, 0, 1), (-1, g, 1), (-1, -g, 1), (-g, 0, 1)]
    side = [(0, 1, 1), (0, 0, 1), (0, -1, 1)]
    return Arrangement([*corners, *side, (0, 1, 0), (1, 0, 0), (h, g, 0), (h, -g, 0)])


def regular_of_pentagon() -> Rows:
    """Return the five sides and the five mirrors of a regular pentagon, A(10, 1) of Gruenbaum."""
    g, _ = golden_ratio()
    corners = [(0, -1, 1), (1, -g, 1), (g, 0, 1), (1, g, 1), (0, 1, 1)]
    centre = (g + 2, 0, 5)
    sides = [_through(corners[k - 1], corners[k]) for k in range(5)]
    return [*sides, *(_through(corner, centre) for corner in corners)]


def _through(p: Sequence[Any], q: Sequence[Any]) -> tuple[Any, Any, Any]:
    """Return the line through two points, all in homogeneous coordinates."""
    return (p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])


def _both(name: str, rows: Rows) -> Iterator[tuple[str, Arrangement]]:
    """Yield lines a x + b y + c = 0 as planes through the origin, and as lines of the plane."""
    yield name, Arrangement(rows)
    yield f"{name.removesuffix(')')}, d=2)", _lines(rows)


def _lines(rows: Rows) -> Arrangement:
    return Arrangement([row[:2] for row in rows], [-row[2] for row in rows])
