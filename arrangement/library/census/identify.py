"""Which type of the census an arrangement of rank 3 has, and how it is brought onto it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from arrangement import counts
from arrangement.arrangement import Arrangement
from arrangement.enumeration.great_circles import sphere_arrangement
from arrangement.enumeration.reduction import in_dimension
from arrangement.errors import InputError
from arrangement.library.families import braid, coordinate, near_pencil, simplicial, type_b
from arrangement.library.families.simplicial import simplicial_entries
from arrangement.planes.identification import Identification
from arrangement.planes.planes import Planes

from .catalogue import MOST_PLANES, chirotopes, exact_chirotope, normals, places
from .chirotopes import Coded, Signs, canonical, relabelling


def identify(arrangement: Planes) -> Identification:
    """Find the isomorphism class of an arrangement among those of the census.

    Types are up to relabelling of planes and exchange of sides. Planes that coincide count once;
    `order` then names the first of them. In rank 1 and 2 there is one type for each number of
    planes; of rank 4 and more, and of more planes than the census has, only the counts are given.
    Lines of R^2 that do not all contain the origin have the class of their cone together with the
    one at infinity (`census.lines` has all of them), and so have other affine planes.

    Raises:
        InputError: the arrangement has no plane.

    >>> found = identify(Arrangement([[1, 2, 0], [0, 1, 1], [3, 0, 1], [1, 3, 1]]))
    >>> found.type, found.names, found.order, found.sides
    (1, ('near-pencil',), (2, 0, 3, 1), (1, 1, 1, -1))
    >>> identify(Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1])).label
    '4.2 with line 1 at infinity'
    """
    from .finschi_fukuda import number as ic_number, representatives, texts

    if not arrangement.is_central:
        return _of_cone(arrangement)
    if not len(arrangement):
        raise InputError("the arrangement has no plane; an empty one has no type in the census")
    firsts = arrangement.firsts
    distinct = Arrangement([plane[:-1] for plane in arrangement.distinct_planes])
    m, rank, f_vector = len(firsts), distinct.rank, distinct.f_vector
    facets, regions = f_vector[-2], f_vector[-1]
    is_simplicial = 2 * facets == rank * regions
    number, automorphisms, names = None, None, tuple[str, ...]()
    listed, text = None, ""
    order, sides, t_vector = tuple[int, ...](), tuple[int, ...](), dict[int, int]()
    if rank != 3:
        is_simple = distinct.is_simple
    if rank < 3:
        number, names = 1, ("pencil",) if rank == 2 and m > 2 else ()
    elif rank == 3:
        incidence = sphere_arrangement(in_dimension(distinct, 3)[0]).incidence
        t_vector = dict(sorted(Counter(np.diff(incidence.line_offsets).tolist()).items()))
        # Faster than the ranks of all triples, and the same where the space has more dimensions.
        is_simple = t_vector.keys() == {2} and (distinct.dimension == 3 or m == 3)
        if m <= MOST_PLANES:
            signs = exact_chirotope(distinct)
            place, orders, turned, mine = locate_type(signs, m)
            number, automorphisms = place + 1, int(mine.automorphisms[0])
            order = tuple(firsts[k] for k in orders)
            sides = tuple(turned.tolist())
            listed, (text,) = ic_number(m, place), texts(representatives(signs[None], m))
            if is_simplicial:
                names = tuple(name for name, known in _with_names(m) if _same(known, mine.codes[0]))
            elif not normals(m)[place].any():
                names = ("Perles",)
    return Identification(
        planes=m,
        rank=rank,
        type=number,
        f_vector=f_vector,
        t_vector=t_vector,
        automorphisms=automorphisms,
        is_simple=is_simple,
        is_simplicial=is_simplicial,
        names=names,
        finschi_fukuda=listed,
        chirotope=text,
        order=order,
        sides=sides,
    )


def _of_cone(arrangement: Planes) -> Identification:
    """Return the class of planes that miss the origin, by that of their cone."""
    planes = arrangement.distinct_planes
    m = len(planes)
    affine = Arrangement([plane[:-1] for plane in planes], [plane[-1] for plane in planes])
    known = identify(counts.cone(affine))
    infinity = None if known.type is None else 0  # of parallel lines any is alike
    automorphisms, order = known.automorphisms, known.order
    if known.type is not None and automorphisms is not None:
        representative = canonical(chirotopes(m + 1, slice(known.type - 1, known.type)), m + 1)
        orbit = representative.orbits[0] == representative.orbits[0, order.index(m)]
        infinity, automorphisms = int(orbit.argmax()), automorphisms // int(orbit.sum())
    firsts = (*arrangement.firsts, len(arrangement))
    return replace(
        known,
        planes=m,
        rank=affine.rank,
        f_vector=affine.f_vector,
        t_vector=counts.t_vector(affine) if affine.rank == 2 else {},
        automorphisms=automorphisms,
        is_simple=affine.is_simple,
        is_simplicial=affine.is_simplicial,
        order=tuple(firsts[k] for k in order),
        infinity=infinity,
    )


@lru_cache(maxsize=MOST_PLANES)
def _catalogue(m: int) -> tuple[Signs, NDArray[np.intp]]:
    """Return the chirotopes of all classes of m planes, and how many triples of each are 0."""
    signs = chirotopes(m)
    return signs, (signs == 0).sum(1)


def locate_type(signs: Signs, m: int) -> tuple[int, NDArray[np.intp], Signs, Coded]:
    """Return the place of a chirotope in the census, how that type is carried onto it, its code.

    Element p of the representative is element ``order[p]``, multiplied by ``sides[p]``. The last
    answer is kept: a chirotope that is read is asked for twice, by coordinates and by name.

    Args:
        signs: (triples) for m elements, 3 to 9.

    Raises:
        LookupError: no planes have these signs.
    """
    return _locate_text(signs.astype(np.int8).tobytes(), m)


@lru_cache(maxsize=1)
def _locate_text(text: bytes, m: int) -> tuple[int, NDArray[np.intp], Signs, Coded]:
    signs = np.frombuffer(text, dtype=np.int8)[None]
    mine = canonical(signs, m)
    place = int(places(signs)[0]) if m == MOST_PLANES else _place(signs, mine.codes[0], m)
    if place < 0:
        raise LookupError("the code is not in the census")
    order, sides = relabelling(mine, canonical(chirotopes(m, slice(place, place + 1)), m))
    return place, order[0], sides[0], mine


def _place(signs: Signs, code: NDArray[np.int64], m: int) -> int:
    """Return the place in the census of up to eight planes, -1 if there is none."""
    known, zeros = _catalogue(m)
    alike = np.flatnonzero(zeros == (signs == 0).sum())
    hits = np.flatnonzero((canonical(known[alike], m).codes == code).all(1))
    return int(alike[hits[0]]) if len(hits) else -1


def _with_names(m: int) -> Iterator[tuple[str, Arrangement]]:
    """Yield the simplicial arrangements of m planes of rank 3 that have usual names."""
    if m == 3:
        yield "coordinate planes", coordinate(3)
    else:
        yield "near-pencil", near_pencil(m)
    if m == 6:
        yield "braid A3", braid(4)
    if m == 9:
        yield "reflection B3", type_b(3)
    for planes, number in simplicial_entries():
        if planes == m:
            yield f"A({planes}, {number})", simplicial(planes, number)


def _same(known: Arrangement, code: NDArray[np.int64]) -> bool:
    codes = canonical(exact_chirotope(known)[None], len(known)).codes
    return bool((codes[0] == code).all())
