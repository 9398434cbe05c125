"""The rational simplicial arrangements of Gruenbaum's catalogue with at most 13 planes.

A central arrangement of rank 3 is simplicial when every region has three facets. A(n, k) is the
k-th entry with n planes in the catalogue; the near-pencils A(n, 0) are an infinite family and in
`near_pencil`. The catalogue is complete up to 27 planes but for four later finds, all larger
than these. All entries up to 13 planes are here except two, which need the golden ratio:

* A(10, 1): sides and mirrors of the regular pentagon;
* A(13, 4).

The normals were found by search: planes with entries up to 2 were added through vertices already
there, until the number of facets is 3/2 of the number of regions. Entries are told apart by the
numbers of vertices of each multiplicity, and of planes with each number of vertices.

Sources: B. Gruenbaum, A catalogue of simplicial arrangements in the real projective plane, Ars
Mathematica Contemporanea 2 (2009); M. Cuntz, Simplicial arrangements with up to 27 lines,
Discrete and Computational Geometry 48 (2012); M. Cuntz, S. Elia, J.-P. Labbe, Congruence
normality of simplicial hyperplane arrangements via oriented matroids, Annals of Combinatorics 26
(2022), table 5.
"""

from __future__ import annotations

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError

_Normals = tuple[tuple[int, int, int], ...]

_FRAME: _Normals = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
_A6: _Normals = (*_FRAME, (1, 1, 0), (0, 1, 1), (1, 1, 1))
_B3: _Normals = (*_FRAME, (1, 1, 0), (1, -1, 0), (1, 0, 1), (1, 0, -1), (0, 1, 1), (0, 1, -1))
_CUBE: _Normals = ((1, 1, 1), (1, 1, -1), (1, -1, 1), (1, -1, -1))
_HEXAGON: _Normals = (*_B3, (1, 1, 1), (1, 1, -1), (1, 2, 0), (2, 1, 0))

_CATALOGUE: dict[tuple[int, int], _Normals] = {
    (6, 1): _A6,
    (7, 1): (*_A6, (1, 0, 1)),
    (8, 1): (*_A6, (1, 0, 1), (0, 1, -1)),
    (9, 1): _B3,
    (10, 2): (*_B3, (1, 1, 1)),
    (10, 3): (*_FRAME, (1, 1, 0), (1, 0, 1), (1, 0, -1), (0, 1, 1), (0, 1, -1), *_CUBE[:2]),
    (11, 1): (*_B3, (1, 1, 1), (1, -1, -1)),
    (12, 1): tuple(normal for normal in _HEXAGON if normal != (0, 0, 1)),
    (12, 2): (*_B3, (1, 1, 1), (1, -1, -1), (0, 2, 1)),
    (12, 3): (*_B3, *_CUBE[:3]),
    (13, 1): _HEXAGON,
    (13, 2): (*_B3, *_CUBE),
    (13, 3): (*_B3, (1, 1, 1), (2, 0, 1), (2, 1, 0), (2, 1, 1)),
}
_IRRATIONAL = {(10, 1), (13, 4)}


def simplicial(planes: int, number: int) -> Arrangement:
    """Return A(planes, number) of Gruenbaum's catalogue, central in R^3.

    Known counts: with t_k vertices (pairs of rays) on k planes, t_2 = 3 + sum over k >= 4 of
    (k - 3) t_k, which is equality in Melchior's inequality; 3/2 as many facets as regions.

    Raises:
        InputError: for an entry that is irrational, unknown, or has more than 13 planes.

    >>> simplicial(13, 2).f_vector
    (1, 50, 144, 96)
    """
    entry = (planes, number)
    if entry in _IRRATIONAL:
        raise InputError(
            f"A{entry} is irrational: its cross-ratios have the golden ratio, so it has no exact "
            "rational normals"
        )
    if entry not in _CATALOGUE:
        known = ", ".join(f"A{key}" for key in _CATALOGUE)
        raise InputError(f"A{entry} is not here; known are {known}, and near_pencil for A(n, 0)")
    return Arrangement(_CATALOGUE[entry])


def simplicial_entries() -> tuple[tuple[int, int], ...]:
    """Return the entries (planes, number) that `simplicial` knows, in the catalogue's order."""
    return tuple(_CATALOGUE)
