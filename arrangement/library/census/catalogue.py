"""The shipped list of types, read and checked on reading; and the types of lines of the plane.

Two arrangements of lines of R^2 are isomorphic if one becomes the other by relabelling and exchange
of sides, as far as sign vectors are concerned: if their cones are so, infinity going to infinity.
So they are the classes of m + 1 lines with an orbit of lines in each, which one at infinity stands
for; and m parallel lines, whose cone has rank 2.
"""

from __future__ import annotations

import json
from bisect import bisect
from collections.abc import Iterator, Sequence
from functools import lru_cache
from importlib.resources import files
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

from arrangement.arrangement import Arrangement
from arrangement.counts.oriented_matroid import chirotope
from arrangement.errors import InputError
from arrangement.library.families import perles
from arrangement.numbers.exact import shown

from .chirotopes import Integers, Signs, canonical, chirotope_of, regions
from .final_polynomials import OrderedProducts

#: The largest number of planes in the shipped list.
MOST_PLANES = 9
#: Published numbers of types, all and simple ([FinschiFukuda2002]).
PUBLISHED = {3: 1, 4: 2, 5: 4, 6: 17, 7: 143, 8: 4890, 9: 460_779}
PUBLISHED_SIMPLE = {3: 1, 4: 1, 5: 1, 6: 4, 7: 11, 8: 135, 9: 4381}
#: Published number of isomorphism classes of nine pseudolines ([FinschiFukuda2002]).
PSEUDOLINES = 461_053
#: The largest number of lines whose classes are in the census.
MOST_LINES = MOST_PLANES - 1
#: Classes of the projective plane whose symmetries are found at once.
_BATCH = 500
#: Types that a search in the list looks at together.
_AT_ONCE = 31


@lru_cache(maxsize=1)
def _document() -> dict[str, Any]:
    text = files(__package__).joinpath("types.json").read_text(encoding="utf-8")
    document: dict[str, Any] = json.loads(text)
    return document


@lru_cache(maxsize=1)
def _extensions() -> dict[str, NDArray[Any]]:
    """Return the arrays of the isomorphism classes of nine planes; see `build`."""
    with files(__package__).joinpath("types9.npz").open("rb") as stream, np.load(stream) as arrays:
        return dict(arrays)


@lru_cache(maxsize=MOST_PLANES)
def normals(planes: int) -> NDArray[np.int8]:
    """Return the normals of every isomorphism class of a given number of planes, (types, planes,
    3), 3 to 9 planes.

    Those of `families.perles` are 0, as that type has no rational coordinates.
    """
    if planes < MOST_PLANES:
        return np.array(_document()["types"][str(planes)], dtype=np.int8)
    arrays = _extensions()
    bases = np.concatenate([normals(planes - 1), arrays["bases"]])[arrays["parents"]]
    return np.concatenate([bases, arrays["vectors"][:, None]], axis=1)


def chirotopes(planes: int, chosen: slice | NDArray[np.intp] = slice(None)) -> Signs:
    """Return the chirotopes of some classes of a given number of planes, (types, triples)."""
    rows = normals(planes)[chosen]
    signs = chirotope_of(rows)
    irrational = np.flatnonzero(~rows.any((1, 2)))
    if len(irrational):
        signs[irrational] = exact_chirotope(perles())
    return signs


def exact_chirotope(arrangement: Arrangement) -> Signs:
    """Return the chirotope of distinct planes of rank 3, of any size and field."""
    return np.array([*chirotope(arrangement).values()], dtype=np.int8)


class Types(Sequence[Arrangement]):
    """Types of one number of planes; each arrangement is made anew when it is asked for."""

    def __init__(self, rows: NDArray[np.int8]) -> None:
        self._rows = rows

    def __len__(self) -> int:
        return len(self._rows)

    @overload
    def __getitem__(self, index: int) -> Arrangement: ...
    @overload
    def __getitem__(self, index: slice) -> Types: ...
    def __getitem__(self, index: int | slice) -> Arrangement | Types:
        rows = self._rows[index]
        if isinstance(index, slice):
            return Types(rows)
        return Arrangement(rows.tolist()) if rows.any() else perles()


@lru_cache(maxsize=2 * MOST_PLANES)
def census(planes: int, *, simple: bool = False) -> Sequence[Arrangement]:
    """Return one arrangement of each isomorphism class of `planes` distinct planes of rank 3.

    Types are up to relabelling of planes and exchange of their sides. All are central, in R^3, with
    small integer normals, but for `families.perles`, which needs sqrt(5). Complete: the numbers are
    the published ones, 1, 2, 4, 17, 143, 4890, 460,779 for 3 to 9 planes (1, 1, 1, 4, 11, 135, 4381
    simple), and no two have the same type. Those of nine planes are made when they are asked for.

    Args:
        planes: 3 to 9.
        simple: only the types in general position.

    Raises:
        InputError: another number of planes.

    Source: the counts, [FinschiFukuda2002]; the representatives, `generate` and `build`.

    >>> [len(census(m)) for m in (3, 4, 5, 6, 7, 9)]
    [1, 2, 4, 17, 143, 460779]
    """
    if type(planes) is not int or not 3 <= planes <= MOST_PLANES:
        raise InputError(
            f"planes is {shown(planes)}; the census has isomorphism classes of 3 to {MOST_PLANES}"
        )
    rows = normals(planes)
    types = Types(rows)
    if planes == MOST_PLANES:  # in the order of numbers of regions: the simple ones come last
        places = range(len(types))
        return types[bisect(places, False, key=lambda k: types[k].is_simple) :] if simple else types
    return tuple(Types(rows[chirotope_of(rows).all(1)]) if simple else types)


def without_coordinates() -> list[tuple[Signs, tuple[OrderedProducts, ...]]]:
    """Return the isomorphism classes of nine pseudolines that no planes have, each with a proof.

    Their number and that of ``census(9)`` make up that of all classes of nine pseudolines,
    `PSEUDOLINES`. `final_polynomials.proves_no_coordinates` checks a proof.
    """
    arrays = _extensions()
    steps = np.searchsorted(arrays["proofs"][:, 0], range(1, len(arrays["without"])))
    return [
        (signs, tuple(OrderedProducts(tuple(row[1:6]), *row[6:]) for row in proof.tolist()))
        for signs, proof in zip(arrays["without"], np.split(arrays["proofs"], steps), strict=True)
    ]


def places(signs: Signs) -> NDArray[np.intp]:
    """Return the place in ``census(9)`` of each chirotope of nine elements, -1 if it has none.

    The list is in the order of numbers of regions, then of codes, so each is found by bisection.
    """
    total, at_once = PUBLISHED[MOST_PLANES], max(1, _AT_ONCE // len(signs))
    wanted = place_keys(signs)
    low, high = np.zeros(len(signs), dtype=np.intp), np.full(len(signs), total)
    while (low < high).any():
        steps = low[:, None] + (high - low)[:, None] * np.arange(1, at_once + 1) // (at_once + 1)
        keys = place_keys(chirotopes(MOST_PLANES, steps.ravel().clip(max=total - 1)))
        keys = keys.reshape(*steps.shape, -1)
        differ = keys != wanted[:, None]
        first = differ.argmax(2)[..., None]
        smaller = np.take_along_axis(keys < wanted[:, None], first, axis=2)[..., 0]
        before = (smaller & differ.any(2)).sum(1)  # as the steps rise, these come first
        ends = np.column_stack([low - 1, steps, high])
        rows, going = np.arange(len(signs)), low < high
        low = np.where(going, ends[rows, before] + 1, low)
        high = np.where(going, ends[rows, before + 1], high)
    places = place_keys(chirotopes(MOST_PLANES, low.clip(max=total - 1)))
    return np.where((places == wanted).all(1), low, -1)


def place_keys(signs: Signs) -> Integers:
    """Return the rows by which the list is sorted: regions, then code."""
    codes = canonical(signs, MOST_PLANES).codes
    return np.column_stack([regions(signs, MOST_PLANES), codes])


def lines(m: int, *, simple: bool = False) -> Iterator[Arrangement]:
    """Yield one arrangement of each isomorphism class of m different lines of the plane R^2.

    There are 1, 2, 4, 9, 47, 791, 37830 for 1 to 7 lines, and 1, 1, 1, 1, 6, 43, 922, 38609 for 1
    to 8 in general position: any two meet, no three in a point.

    Args:
        m: 1 to 8.
        simple: only the classes in general position.

    Raises:
        InputError: another number of lines.

    Source: the counts, OEIS A241600 and A090338.

    >>> [sum(1 for _ in lines(m)) for m in range(1, 6)]
    [1, 2, 4, 9, 47]
    """
    if _number(m) == 1 or not simple:
        yield Arrangement([[1, 0]] * m, range(m))
    types = census(m + 1) if m > 1 else ()
    for place, infinity in _at_infinity(m, simple=simple):
        yield _without_line(types[place], infinity)


def line_count(m: int, *, simple: bool = False) -> int:
    """Return the number of `lines`, from chirotopes alone.

    >>> line_count(4), line_count(6, simple=True)
    (9, 43)
    """
    return (_number(m) == 1 or not simple) + sum(1 for _ in _at_infinity(m, simple=simple))


def _number(m: int) -> int:
    if type(m) is not int or not 1 <= m <= MOST_LINES:
        raise InputError(f"m is {shown(m)}; the census has 1 to {MOST_LINES} lines of the plane")
    return m


def _at_infinity(m: int, *, simple: bool) -> Iterator[tuple[int, int]]:
    """Yield the places of the classes of m + 1 lines, each with a line of every orbit."""
    total = PUBLISHED.get(m + 1, 0)
    # In the order of numbers of regions: the simple ones come last.
    for start in range(total - PUBLISHED_SIMPLE[m + 1] if simple and total else 0, total, _BATCH):
        orbits = canonical(chirotopes(m + 1, slice(start, start + _BATCH)), m + 1).orbits
        for k, infinity in np.argwhere(orbits == np.arange(m + 1)).tolist():
            yield start + k, infinity


def _without_line(planes: Arrangement, infinity: int) -> Arrangement:
    """Return the other lines of the projective plane, in coordinates with one at infinity."""
    rows: list[Any] = [plane[:-1] for plane in planes.integer_planes]
    far = rows.pop(infinity)
    last = next(k for k, x in enumerate(far) if x)
    one, two = (k for k in range(3) if k != last)
    normals = [[far[last] * row[k] - row[last] * far[k] for k in (one, two)] for row in rows]
    return Arrangement(normals, [-row[last] for row in rows])
