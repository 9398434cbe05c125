"""Chirotopes of rank 3 in batches, and codes that distinguish their types.

A chirotope of n elements is written as the signs of its triples i < j < k in lexicographic order
(int8, shape (..., C(n, 3))), or as an alternating array (..., n, n, n). Elements have no loops and
no two are parallel; chi and -chi are one oriented matroid.

An oriented matroid of rank 3 without parallel elements is an arrangement of pseudolines. A *flag*
is a vertex, an edge at it and a region at that edge, up to the antipode. It numbers the lines:

* line 0 carries the edge; from the vertex on, along the edge, come the lines that cross line 0;
* lines through one point of line 0 are ordered by turning from line 0 into the region;
* each line has the region on its positive side.

The text of a flag is its chirotope under that numbering, up to the common sign. The code is the
least text over all flags, so relabelling and reorientation do not change it, and the text gives
the type back. Automorphisms act freely on flags, so as many flags share the least text as there
are automorphisms.

Signs: let v be the flag's vertex, on the lines e and f, and g a line that misses v. The region is
T = v o (+-g's point on e) o (+-e), a composition of cocircuits. With chi' = chi reoriented by T,
`chi'(e, j, k)` is the order of j and k along e. Where it is 0, the sum over x of
`chi'(j, k, x) chi'(e, j, x)` has the sign of the order around their common point, since there
both factors change sign together.
"""

from __future__ import annotations

import itertools
from functools import cmp_to_key, lru_cache
from math import comb
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from arrangement.errors import InputError

Signs: TypeAlias = NDArray[np.int8]

#: Entries up to this size have determinants that int64 holds: 6 * 10^18 < 2^63.
LARGEST_ENTRY = 10**6


@lru_cache
def triples(n: int) -> NDArray[np.intp]:
    """Return the triples i < j < k below n, in lexicographic order."""
    return np.array(list(itertools.combinations(range(n), 3)), dtype=np.intp).reshape(-1, 3)


@lru_cache
def pairs(n: int) -> NDArray[np.intp]:
    """Return the pairs i < j below n, in lexicographic order."""
    return np.array(list(itertools.combinations(range(n), 2)), dtype=np.intp).reshape(-1, 2)


def chirotope_of(normals: NDArray[np.integer[Any]]) -> Signs:
    """Return the signs of the determinants of all triples of normals, shape (..., n, 3).

    Raises:
        InputError: an entry is larger than `LARGEST_ENTRY` in absolute value.
    """
    if np.abs(normals).max(initial=0) > LARGEST_ENTRY:
        raise InputError(f"entries of normals are at most {LARGEST_ENTRY} here")
    large = normals.astype(np.int64)
    first, second, third = (large[..., column, :] for column in triples(normals.shape[-2]).T)
    signs: Signs = np.sign((np.cross(first, second) * third).sum(-1)).astype(np.int8)
    return signs


def alternating(signs: Signs, n: int) -> Signs:
    """Return the alternating arrays (N, n, n, n) of chirotopes (N, C(n, 3))."""
    chi = np.zeros((len(signs), n, n, n), dtype=np.int8)
    i, j, k = triples(n).T
    for a, b, c in ((i, j, k), (j, k, i), (k, i, j)):
        chi[:, a, b, c] = signs
        chi[:, b, a, c] = -signs
    return chi


def extended(signs: Signs, localizations: Signs, n: int) -> Signs:
    """Return the chirotopes of n + 1 elements, given those of the last with each pair.

    Args:
        signs: one chirotope of n elements, (C(n, 3),).
        localizations: signs of (i, j, new) for the pairs i < j, (K, C(n, 2)).
    """
    new = triples(n + 1)
    last = new[:, 2] == n
    result = np.empty((len(localizations), len(new)), dtype=np.int8)
    result[:, ~last] = signs
    result[:, last] = localizations
    return result


def t_vectors(signs: Signs, n: int) -> NDArray[np.int64]:
    """Return how many points lie on k elements, for k = 0 to n: (N, n + 1)."""
    i, j = pairs(n).T
    through = (alternating(signs, n)[:, i, j] == 0).sum(2)  # both elements of the pair among them
    on = [(through == k).sum(1) // max(comb(k, 2), 1) for k in range(n + 1)]
    return np.stack(on, 1)


def regions(signs: Signs, n: int) -> NDArray[np.int64]:
    """Return how many regions each arrangement of pseudolines has, by Euler's formula: (N,)."""
    return 2 + 2 * t_vectors(signs, n)[:, 2:] @ np.arange(1, n)


Integers: TypeAlias = NDArray[np.int64]

#: The ternary digits that one int64 holds.
_DIGITS = 39
_POWERS = 3 ** np.arange(_DIGITS - 1, -1, -1, dtype=np.int64)
#: Chirotopes that are worked on together; more would not fit the caches.
_TOGETHER = 1000
_LARGEST = np.iinfo(np.int64).max


class Coded(NamedTuple):
    """Codes of N chirotopes, and how each is brought to its canonical form.

    Attributes:
        codes: integers, (N, words).
        orders: (N, n); element `orders[a, p]` becomes element p.
        sides: (N, n); the sign by which element p of the canonical form was multiplied.
        automorphisms: (N,), the order of the group that keeps the chirotope up to sign, by
            relabelling and reorientation, all elements at once counting as nothing.
        orbits: (N, n), for each element the least one of its orbit under that group.
    """

    codes: Integers
    orders: NDArray[np.intp]
    sides: Signs
    automorphisms: Integers
    orbits: Integers


def canonical(signs: Signs, n: int) -> Coded:
    """Return canonical codes of chirotopes of rank 3, (N, C(n, 3)), without parallel elements.

    3 to 12 elements. 0.1 to 0.3 ms each for nine elements.
    """
    parts = [
        _canonical(alternating(signs[low : low + _TOGETHER], n), n)
        for low in range(0, len(signs), _TOGETHER)
    ]
    return Coded(*(np.concatenate(columns) for columns in zip(*parts, strict=True)))


def relabelling(mine: Coded, theirs: Coded) -> tuple[NDArray[np.intp], Signs]:
    """Return how chirotopes of the same codes are carried onto others: orders and sides, (N, n).

    Element p of theirs is element ``order[p]`` of mine, multiplied by ``sides[p]``.
    """
    back = np.argsort(theirs.orders, axis=1)
    shape = np.broadcast_shapes(mine.orders.shape, back.shape)
    back = np.broadcast_to(back, shape)
    order = np.take_along_axis(mine.orders, back, axis=1)
    return order, np.take_along_axis(mine.sides * theirs.sides, back, axis=1)


def _canonical(chi: Signs, n: int) -> Coded:
    total = len(chi)
    code, flags = _along_first_lines(chi, n)
    words = [code]
    of, order, sides = flags
    flat, start = chi.reshape(-1), of * n**3
    # Triples with line 0 are compared by the first word; all others are compared by parts.
    others = triples(n)[triples(n)[:, 0] > 0]
    for part in _parts(others):
        i, j, k = part.T
        index = (order[:, i] * n + order[:, j]) * n + order[:, k] + start[:, None]
        digits = flat.take(index) * (sides[:, i] * sides[:, j] * sides[:, k] * sides[:, n:])
        word = (digits + 1).astype(np.int64) @ _POWERS[_DIGITS - len(part) :]
        least = np.full(total, _LARGEST)
        np.minimum.at(least, of, word)
        words.append(least)
        kept = word == least[of]
        of, order, sides, start = of[kept], order[kept], sides[kept], start[kept]
    _, first, number = np.unique(of, return_index=True, return_counts=True)
    # The flags with the least text are one orbit, so what they have at one place is one too.
    least = np.full((total, n), n)
    np.minimum.at(least, of, order)
    orders, orbits = order[first], np.empty_like(least)
    np.put_along_axis(orbits, orders, least, axis=1)
    return Coded(np.stack(words, 1), orders, sides[first, :n], number, orbits)


def _parts(rows: NDArray[np.intp]) -> list[NDArray[np.intp]]:
    near = rows[:, 0] == 1
    rest = rows[~near]
    return [rows[near], *np.array_split(rest, -(-len(rest) // _DIGITS))] if len(rest) else [rows]


def _along_first_lines(
    chi: Signs, n: int
) -> tuple[Integers, tuple[NDArray[np.intp], NDArray[np.intp], Signs]]:
    """Return the first word of each code, and the flags that have it.

    The first word is how many lines cross line 0 in its first point, its second, ...; the
    largest is taken, since it leaves fewest flags. A flag is (chirotope, order, sides), with the
    common sign of its text as one more side.
    """
    total = len(chi)
    flags = [_flags(chi, line, other) for line in range(n) for other in range(n) if other != line]
    of, line, sides, along, sign = (np.concatenate(c) for c in zip(*flags, strict=True))
    after = (along > 0).sum(2)
    after[np.arange(len(of)), line] = 0
    counts = (np.int64(1) << (4 * after)).sum(1)
    most = np.zeros(total, dtype=np.int64)
    np.maximum.at(most, of, counts)
    kept = counts == most[of]
    of, line, sides, along, sign = of[kept], line[kept], sides[kept], along[kept], sign[kept]
    around = _around_points(chi, n)[of, line]
    rows = np.arange(len(of))
    orders, all_sides = [], []
    for side in (1, -1):
        sides = sides.copy()
        sides[rows, line] = side
        before = np.where(along == 0, around * (side * sides)[:, None, :], along) < 0
        position = before.sum(2)
        position[rows, line] = -1
        order = np.argsort(position, axis=1, kind="stable")
        orders.append(order)
        common = (side * sign)[:, None].astype(np.int8)
        all_sides.append(np.hstack([np.take_along_axis(sides, order, 1), common]))
    return most, (np.concatenate([of, of]), np.concatenate(orders), np.concatenate(all_sides))


def _flags(chi: Signs, line: int, other: int) -> tuple[NDArray[np.generic], ...]:
    """The vertex of `line` and `other` with both directions, where `other` is its least line."""
    through = chi[:, line, other] == 0
    through[:, line] = False
    of = np.flatnonzero(~through[:, :other].any(1))
    rows = np.arange(len(of))
    contraction = chi[of, line]
    vertex = contraction[:, other]
    missing = (vertex != 0).argmax(1)
    ahead = contraction[rows, missing]
    parts = []
    for direction in (1, -1):
        sides = np.where(vertex != 0, vertex, direction * ahead).astype(np.int8)
        sides[:, line] = 1
        along = contraction * sides[:, :, None] * sides[:, None, :]
        sign = along[rows, other, missing]
        along *= sign[:, None, None]
        parts.append((of, np.full(len(of), line), sides, along, sign))
    return tuple(np.concatenate(columns) for columns in zip(*parts, strict=True))


def _around_points(chi: Signs, n: int) -> Signs:
    """Signs [e, j, k] of the sum over x of chi(j, k, x) chi(e, j, x)."""
    rows = chi.reshape(len(chi), n * n, n).astype(np.float32)  # sums of n signs: exact
    sums = (rows @ rows.transpose(0, 2, 1)).reshape(len(chi), n, n, n, n)
    result = np.empty((len(chi), n, n, n), dtype=np.int8)
    for j in range(n):
        result[:, :, j, :] = np.sign(sums[:, j, :, :, j]).transpose(0, 2, 1)
    return result


def extensions(signs: Signs, n: int) -> Signs:
    """Return all extensions of one chirotope by an element that is parallel to none.

    A one-element extension of an oriented matroid is given by a sign for each cocircuit, opposite
    at opposite ones. Signs belong to an extension exactly when they do so on every contraction of
    rank 2 ([LasVergnas1978]; [BjornerLasVergnasSturmfelsWhiteZiegler1999], theorem 7.1.8). In rank
    3 these are the lines: around each line the signs change once within the points of a half turn,
    with or without a 0 at the change. (All 0 would be an element parallel to the line.) So lines
    are taken one after another, and what agrees on their common points is joined.

    Args:
        signs: the chirotope's signs, (C(n, 3),).
        n: its number of elements.

    Returns:
        The signs of (i, j, new) for the pairs i < j, (K, C(n, 2)); of the two signs of the new
        element one is listed.
    """
    chi = alternating(signs[None], n)[0]
    point, side = _points(chi)
    values = np.zeros((1, point.max() + 1), dtype=np.int8)
    known = np.zeros(point.max() + 1, dtype=bool)
    for line in range(n):
        on, patterns = _sign_patterns(chi, line, point, side)
        shared = known[on]
        fits = (values[:, None, on[shared]] == patterns[None, :, shared]).all(2)
        row, pattern = np.nonzero(fits)
        values = values[row]
        values[:, on] = patterns[pattern]
        known[on] = True
    i, j = pairs(n).T
    all_signs: Signs = values[:, point[i, j]] * side[i, j]
    first = all_signs[np.arange(len(all_signs)), (all_signs != 0).argmax(1)]
    listed: Signs = all_signs[first > 0]
    return listed


def _points(chi: Signs) -> tuple[NDArray[np.intp], Signs]:
    """Number the points where lines meet; give the cocircuit of (i, j) as a sign times theirs."""
    n = len(chi)
    point = np.full((n, n), -1, dtype=np.intp)
    side = np.zeros((n, n), dtype=np.int8)
    number = 0
    for i, j in pairs(n):
        if point[i, j] < 0:
            through = np.flatnonzero(chi[i, j] == 0)
            missing = np.flatnonzero(chi[i, j])[0]
            grid = np.ix_(through, through)
            point[grid] = number
            side[grid] = chi[i, j, missing] * chi[(*grid, missing)]
            number += 1
    return point, side


def _sign_patterns(
    chi: Signs, line: int, point: NDArray[np.intp], side: Signs
) -> tuple[NDArray[np.intp], Signs]:
    """Return the points of a line in order, and every way that signs may go along them."""
    others = [j for j in range(len(chi)) if j != line]
    first_through = {point[line, j]: j for j in reversed(others)}
    base, *rest = first_through.values()
    turned = {j: int(chi[line, base, j]) for j in rest}

    def before(a: int, b: int) -> int:
        return -int(chi[line, a, b]) * turned[a] * turned[b]

    rest.sort(key=cmp_to_key(before))
    order = [base, *rest]
    sides = np.array([side[line, base], *(turned[j] * side[line, j] for j in rest)])
    size = len(order)
    change = np.arange(size)[:, None]
    plain = np.where(np.arange(size) < change, 1, -1)
    with_zero = np.where(np.arange(size) == change, 0, plain)
    patterns = np.concatenate([plain, -plain, with_zero, -with_zero]) * sides
    return point[line, order], patterns.astype(np.int8)
