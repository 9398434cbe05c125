"""Which type of the census an arrangement of rank 3 has, and how it is brought onto it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from math import comb

import numpy as np
from numpy.typing import NDArray

from arrangement.arrangement import Arrangement
from arrangement.counts.oriented_matroid import chirotope
from arrangement.errors import InputError
from arrangement.library.families import braid, coordinate, near_pencil, simplicial
from arrangement.library.families.simplicial import simplicial_entries
from arrangement.planes import Planes

from .catalogue import MOST_PLANES, normals
from .chirotopes import Signs, alternating, chirotope_of
from .codes import Coded, canonical


@dataclass(frozen=True)
class Identification:
    """What is known of an arrangement's combinatorial type.

    Attributes:
        planes: the number m of distinct planes.
        rank: of the normals.
        type: the number of the type within m, from 1 on: type k is ``census(m)[k - 1]``. None
            for other ranks than 3 and beyond the census.
        f_vector: faces of each dimension.
        t_vector: t[k] points (lines through the origin) lie on k distinct planes; rank 3 only.
        automorphisms: how many relabellings with exchanges of sides keep the type, where
            exchanging all sides at once counts as nothing; None where type is.
        is_simple: the planes are in general position.
        is_simplicial: every region has as many facets as the rank.
        names: usual names of the type.
        order: plane p of the catalogue's representative is plane ``order[p]`` here.
        sides: and its normal is turned by ``sides[p]``.
    """

    planes: int
    rank: int
    type: int | None
    f_vector: tuple[int, ...]
    t_vector: Mapping[int, int]
    automorphisms: int | None
    is_simple: bool
    is_simplicial: bool
    names: tuple[str, ...]
    order: tuple[int, ...]
    sides: tuple[int, ...]


def identify(arrangement: Planes) -> Identification:
    """Find the combinatorial type of a central arrangement among those of the census.

    Types are up to relabelling of planes and exchange of sides. Planes that coincide count once;
    `order` then names the first of them. In rank 1 and 2 there is one type for each number of
    planes; of rank 4 and more, and of more planes than the census has, only the counts are given.

    Raises:
        InputError: the arrangement is not central, or has no plane.

    >>> found = identify(Arrangement([[1, 2, 0], [0, 1, 1], [3, 0, 1], [1, 3, 1]]))
    >>> found.type, found.names, found.order, found.sides
    (1, ('near-pencil',), (2, 0, 3, 1), (1, 1, 1, -1))
    """
    if not arrangement.is_central:
        raise InputError("the arrangement is not central; identify its cone (counts.cone)")
    if not len(arrangement):
        raise InputError("the arrangement has no plane; an empty one has no type in the census")
    firsts = [members[0] for members in arrangement.distinct]
    distinct = Arrangement([arrangement.normals[k] for k in firsts])
    m, rank, f_vector = len(firsts), distinct.rank, distinct.f_vector
    facets, regions = f_vector[-2], f_vector[-1]
    number, automorphisms, names = None, None, tuple[str, ...]()
    order, sides, t_vector = tuple[int, ...](), tuple[int, ...](), dict[int, int]()
    if rank < 3:
        number, names = 1, ("pencil",) if rank == 2 and m > 2 else ()
    elif rank == 3:
        signs = np.array([*chirotope(distinct).values()], dtype=np.int8)[None]
        t_vector = _points(signs[0], m)
        if m <= MOST_PLANES:
            mine = canonical(signs, m)
            place, theirs = _found(signs[0], mine.codes[0], m)
            back = np.argsort(theirs.orders[0])
            number, automorphisms = place + 1, int(mine.automorphisms[0])
            order = tuple(firsts[k] for k in mine.orders[0][back])
            sides = tuple((mine.sides[0] * theirs.sides[0])[back].tolist())
            names = tuple(name for name, known in _named(m) if _same(known, mine.codes[0]))
    return Identification(
        planes=m,
        rank=rank,
        type=number,
        f_vector=f_vector,
        t_vector=t_vector,
        automorphisms=automorphisms,
        is_simple=distinct.is_simple,
        is_simplicial=2 * facets == rank * regions,
        names=names,
        order=order,
        sides=sides,
    )


def _points(signs: Signs, m: int) -> dict[int, int]:
    """Return how many points lie on k planes, for each k that occurs."""
    through = (alternating(signs[None], m)[0] == 0).sum(2)  # both planes of the pair among them
    pairs_on = Counter(int(through[i, j]) for j in range(m) for i in range(j))
    return {k: number // comb(k, 2) for k, number in sorted(pairs_on.items())}


@lru_cache(maxsize=MOST_PLANES)
def _catalogue(m: int) -> tuple[Signs, NDArray[np.intp]]:
    """Return the chirotopes of all types of m planes, and how many triples of each are 0."""
    signs = chirotope_of(np.array(normals(m), dtype=np.int64))
    return signs, (signs == 0).sum(1)


def _found(signs: Signs, code: NDArray[np.int64], m: int) -> tuple[int, Coded]:
    """Return the place of a code in the census, and how that representative becomes canonical."""
    known, zeros = _catalogue(m)
    places = np.flatnonzero(zeros == (signs == 0).sum())
    theirs = canonical(known[places], m)
    (hit,) = np.flatnonzero((theirs.codes == code).all(1))
    return int(places[hit]), canonical(known[places[hit : hit + 1]], m)


def _named(m: int) -> Iterator[tuple[str, Arrangement]]:
    """Yield the arrangements of m planes of rank 3 that have usual names."""
    if m == 3:
        yield "coordinate planes", coordinate(3)
    else:
        yield "near-pencil", near_pencil(m)
    if m == 6:
        yield "braid A3", braid(4)
    for planes, number in simplicial_entries():
        if planes == m:
            yield f"A({planes}, {number})", simplicial(planes, number)


def _same(known: Arrangement, code: NDArray[np.int64]) -> bool:
    signs = np.array([*chirotope(known).values()], dtype=np.int8)[None]
    return bool((canonical(signs, len(known)).codes[0] == code).all())
