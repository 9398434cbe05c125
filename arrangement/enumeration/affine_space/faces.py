"""All faces of planes of rank 3 in R^3 at scale, central or affine."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

import numpy as np

from arrangement.coefficients import Integers
from arrangement.enumeration.packing import Words, pack, unit_words, unpack
from arrangement.enumeration.sequence import Level, Rows, Signs
from arrangement.planes import Planes

from .faces_around_lines import faces_around
from .lines import trace_lines
from .points import Points
from .predicates import Indices, PlaneTable

#: From chosen faces to the classes with sign +, and to those with sign 0, whose + does not count.
_Sides: TypeAlias = Callable[[Indices], tuple[Words, Words]]


def space_levels(planes: Planes) -> tuple[Level, ...]:
    """Return the faces of dimension 0 to 3 of planes of rank 3 in R^3.

    Exact for every input: coincident and parallel planes, pencils, many planes through one point,
    entries of any size. Floats only propose; each decision is certified or taken by integers.

    Complexity: O(n^3) faces for n planes; O(n^3 log n) time and O(n^3) memory. The constants are
    those of numpy, unless so many determinants vanish or nearly vanish that integers decide most.
    """
    table = PlaneTable(planes.distinct_planes)
    lines = trace_lines(table)
    faces = faces_around(table, lines)
    points = Points(table, lines, faces)
    words, through, units = lines.words, pack(lines.through), unit_words(len(table))
    columns, orientation = np.array(planes.class_of), np.array(planes.orientation, np.int8)

    def vertices(rows: Indices) -> tuple[Words, Words]:
        below = faces.vertices[rows]
        return words[below], words[below] ^ words[below + 1] | through[lines.line[below]]

    def level(count: int, sides: _Sides, inside: Callable[[Indices], Integers]) -> Level:
        def signs(rows: Rows) -> Signs:
            positive, zero = sides(np.arange(count)[rows])
            found = 2 * unpack(positive, len(table)).view(np.int8) - 1
            found[unpack(zero, len(table)).view(bool)] = 0
            return found[:, columns] * orientation

        return Level(count, signs, lambda rows: inside(np.arange(count)[rows]))

    return (
        level(len(faces.vertices), vertices, points.vertices),
        level(len(words), lambda rows: (words[rows], through[lines.line[rows]]), points.edges),
        level(
            len(faces.facets),
            lambda rows: (faces.facets[rows], units[faces.on[rows]]),
            points.facets,
        ),
        level(
            len(faces.regions),
            lambda rows: (faces.regions[rows], np.zeros_like(faces.regions[rows])),
            points.regions,
        ),
    )
