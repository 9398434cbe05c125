"""Root systems by type, and their mirrors.

Of a crystallographic type, a plane's normal is its root written in simple roots. So mirrors span
the space, entries are small integers, and no irrational coordinates come up; angles are not those
of the reflections.
"""

from __future__ import annotations

import re

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.numbers.exact import IntegerVector, shown

from .classical import h3, h4
from .polygons import mirrors

_TYPE = re.compile(r"([A-G])([1-9][0-9]?)")
_RANKS = {
    "A": range(1, 100),
    "B": range(2, 100),
    "C": range(2, 100),
    "D": range(3, 100),
    "E": range(6, 9),
    "F": range(4, 5),
    "G": range(2, 3),
}


def coxeter(type: str) -> Arrangement:
    """Return the mirrors of a type: A1, A2, ..., B2, C2, D3, E6, E7, E8, F4, G2, H3, H4, I2(m).

    Known counts: as many regions as the reflection group has elements (E8: 696,729,600);
    chi(t) is the product of t - e over the exponents e of the type.
    Source: P. Orlik, L. Solomon, Inventiones Mathematicae 56 (1980); N. Bourbaki, Groupes et
    algebres de Lie, chapter VI (1968), plates I to IX.

    Raises:
        InputError: no such type.

    >>> coxeter("F4").f_vector[-1]
    1152
    """
    if type in ("H3", "H4"):
        return h3() if type == "H3" else h4()
    polygon = re.fullmatch(r"I2\(([1-9][0-9]{0,2})\)", type) if isinstance(type, str) else None
    if polygon and int(polygon[1]) >= 3:
        return Arrangement(mirrors(int(polygon[1])))
    return Arrangement(positive_roots(type))


def positive_roots(type: str) -> list[IntegerVector]:
    """Return the positive roots of a crystallographic type, as coefficients of simple roots.

    Simple roots are numbered as by Bourbaki, except that G2's first is the short one too.
    """
    cartan = _cartan_matrix(type)
    size = len(cartan)
    roots = [tuple(int(i == j) for j in range(size)) for i in range(size)]
    known = set(roots)
    for root in roots:
        for i in range(size):
            pairing = sum(root[j] * cartan[j][i] for j in range(size))
            image = (*root[:i], root[i] - pairing, *root[i + 1 :])
            if image[i] >= 0 and image not in known:
                known.add(image)
                roots.append(image)
    return sorted(roots, key=lambda root: (sum(root), root[::-1]))


def _cartan_matrix(type: str) -> list[list[int]]:
    """Return the pairings of simple roots (rows) with simple coroots (columns)."""
    found = _TYPE.fullmatch(type) if isinstance(type, str) else None
    if found is None or int(found[2]) not in _RANKS[found[1]]:
        raise InputError(
            f"the type is {shown(type)}; there are A1, A2, ..., B2, C2, ..., D3, ..., E6, E7, E8, "
            "F4 and G2, and as mirrors H3, H4 and I2(m) for m from 3 on"
        )
    letter, size = found[1], int(found[2])
    edges = [(i, i + 1) for i in range(size - 1)]
    if letter == "D":
        edges[-1] = (size - 3, size - 1)
    if letter == "E":
        edges = [(0, 2), (1, 3), *((i, i + 1) for i in range(2, size - 1))]
    matrix = [[2 * (i == j) for j in range(size)] for i in range(size)]
    for i, j in edges:
        matrix[i][j] = matrix[j][i] = -1
    if letter in "BF":  # the later root of the double bond is the short one
        i = size - 2 if letter == "B" else 1
        matrix[i][i + 1] = -2
    if letter == "C":
        matrix[size - 1][size - 2] = -2
    if letter == "G":
        matrix[1][0] = -3
    return matrix
