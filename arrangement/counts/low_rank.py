"""Counts of flats for configurations of rank at most 4, straight from the vectors.

This covers central arrangements of rank up to 4 and affine ones of rank up to 3, degenerate or
not. Nothing is enumerated but the flats of rank 2 and 3, as groups of equal ratios.

**Rank 2.** Contract by one vector a: planes c and c' lie on one flat with a exactly when their
images in the quotient by a are proportional. The flat is counted at its smallest plane.

**Rank 3.** Contract by a flat of rank 2, spanned by its two smallest planes a < b: the quotient
has two coordinates, the 3 x 3 minors of (a, b, c), so planes are grouped by one ratio. A flat of
rank 3 is counted at the flat spanned by its own two smallest planes: exactly one.
Groups that contain infinity are empty intersections and are left out.

**Moebius values.** In an interval of length 2 with k atoms, mu = k - 1. In one of length 3 the
sum of mu over the interval is 0, so ``|mu| = 1 - (atoms) + sum over rank 2 of (k - 1)``. With

    m planes,  L flats of rank 2,  S = sum of their numbers of planes,
    P flats of rank 3,  M = sum of their numbers of planes,
    K pairs (flat of rank 2 inside one of rank 3),  I = sum over these pairs of the planes
    of the smaller flat,

the sums ``V[k][j]`` of |mu(X, Y)| over flats X <= Y of ranks k and j are

    V[0] = 1, m, S - L, P - M + I - K;  V[1] = m, S, I - M;  V[2] = L, K;  V[3] = P.

**Top.** A central configuration has one flat of full rank r, and mu sums to 0 over each [X, top]:
``V[k][r] = sum_{j < r} (-1)^(r-1-j) V[k][j]``.

**Exactness.** The numbers compared are minors of order at most 3, at most 6 B^3 in size, partial
sums included, for entries up to B. Up to that bound they are int64 (B up to 1,154,107; in rank 3
the bound is 2 B^2, so B up to 2 * 10^9), else Python integers in the same arrays. In rank 3 most
flats are distinguished by slopes in float64 (`_rank_two_sums`). SymPy's matrices take 5 to 25 times
as long for the same groups, for 20 to 200 planes of rank 3.
Irrational vectors are grouped by `modular` instead.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from arrangement.console.progress import watched
from arrangement.numbers import budget
from arrangement.numbers.deadline import check_time
from arrangement.numbers.exact import fast_integers, largest, work_factor

from .configuration import Configuration
from .modular import ModularVectors
from .ratio_groups import (
    Groups,
    Integers,
    close_slopes,
    contract_by_one,
    contract_by_two,
    equal_slopes,
    group_ratios,
    keep_groups,
    row_chunks,
    without_infinity,
)

#: Highest rank, infinity included, that this module counts.
MAX_RANK = 4
_INT64_MAX = 2**63 - 1
#: Planes through which flats of rank 2 are counted to foresee how many there are.
_SAMPLE = 16
#: Steps for each pair of planes whose slopes are sorted.
_SORT_STEPS = 1 / 35

WhitneyMatrix = tuple[tuple[int, ...], ...]


def whitney_matrix(config: Configuration) -> WhitneyMatrix:
    """Return the doubly indexed Whitney numbers, unsigned, of a configuration of rank <= 4.

    Complexity: O(m^2 log m) up to rank 3, O(L m log m) with L <= m^2/2 in rank 4; memory
    O(m + 2^19) (irrational: O(m^2)) and O(L + 2^19), in numbers.
    """
    below_top = _below_top(config)
    if config.infinity is not None:
        return below_top
    return with_top(below_top, config.rank)


def rank_two_groups(config: Configuration) -> Groups:
    """Return the flats of rank 2, each once, as group of the planes beside its smallest (`row`).

    For rank 3 and 4 only.
    """
    parts = _rank_two_parts(config, 130 * len(config.vectors) ** 2)
    columns = zip(*(vars(part).values() for part in parts), strict=True)
    return Groups(*map(np.concatenate, columns))


def _rank_two_parts(config: Configuration, bytes: float) -> Iterator[Groups]:
    """Yield the flats of rank 2 of some rows after the other.

    Args:
        bytes: that they take together.
    """
    vectors, m = _matrix(config), len(config.vectors)
    if isinstance(vectors, ModularVectors):  # all at once
        bytes = 130 * m * m
    _check_cost(f"the flats of rank 2 of {m:,} planes", config, m * m / 2, bytes)
    if isinstance(vectors, ModularVectors):
        bases = np.arange(m)[:, None]
        groups = iter([_covers(vectors, bases, np.eye(m, vectors.count, dtype=np.bool_))])
    else:
        parts = row_chunks(m, len(vectors))
        groups = (group_ratios(contract_by_one(vectors, rows), rows) for rows in parts)
    for group in groups:
        check_time()
        # A plane is in no group of its own row, so the first one is never equal to it.
        yield keep_groups(without_infinity(group, m), lambda g: g.first > g.row)


def _below_top(config: Configuration) -> WhitneyMatrix:
    """Return V for the flats of rank below `config.rank`."""
    m = len(config.vectors)
    if config.rank <= 1:
        return ((1,),) if config.rank else ()
    if config.rank == 2:
        return ((1, m), (0, m))
    if config.rank == 4 and m > _SAMPLE:
        _check_cost(f"the flats of rank 3 of {m:,} planes", config, m * _about_rank_two(config), 0)
    if config.rank == 3:
        count, planes = _rank_two_sums(config)
        return ((1, m, planes - count), (0, m, planes), (0, 0, count))
    lines = rank_two_groups(config)
    count, planes = len(lines.row), int(lines.size.sum()) + len(lines.row)
    points, point_planes, pairs, triples = _rank_three_sums(config, lines)
    return (
        (1, m, planes - count, points - point_planes + triples - pairs),
        (0, m, planes, triples - point_planes),
        (0, 0, count, pairs),
        (0, 0, 0, points),
    )


def _rank_two_sums(config: Configuration) -> tuple[int, int]:
    """Return L and S of the module's notes for a configuration of rank 3.

    Each plane meets the later ones in lines, whose slopes in float64 are sorted. A flat of k planes
    is a group of k - 1, ..., 2, 1 equal slopes at its first k - 1 planes: so L groups have one
    member, and there are S - L in all.

    Quotients of integers up to Q = 2 B^2 that differ do so by 1 / Q^2 of their size at least, so
    where that is above 2^-51 (B up to 4,871) rounding keeps them apart, and equal ones round alike;
    the integers themselves are exact in float64. Of larger int64 only slopes that floats do not
    distinguish are compared exactly.
    """
    vectors, m = _matrix(config), len(config.vectors)
    if isinstance(vectors, ModularVectors) or vectors.dtype == object:
        count = planes = 0
        for part in _rank_two_parts(config, 0):
            count += len(part.row)
            planes += int(part.size.sum()) + len(part.row)
        return count, planes
    steps = m * m * _SORT_STEPS
    budget.check_cost(f"the flats of rank 2 of {m:,} planes", "leave out planes", long_steps=steps)
    largest_quotient = 2 * int(np.abs(vectors).max()) ** 2
    if distinct := largest_quotient**2 < 2**51:
        vectors = vectors.astype(np.float64)
    alone = groups = 0
    for parts in _with_later(vectors, m):
        sums = (equal_slopes if distinct else close_slopes)(parts, len(vectors) > m)
        alone += sums[0]
        groups += sums[1]
    return alone, alone + groups


def _with_later(vectors: Integers, m: int) -> Iterator[list[Integers]]:
    """Yield two coordinates of all later vectors in the quotient by each of some of the first m.

    They are 0 for the vector itself and those before it.
    """
    pivots = (vectors[:m] != 0).argmax(axis=1)
    order = np.append(np.argsort(pivots, kind="stable"), np.arange(m, len(vectors)))
    columns = np.ascontiguousarray(vectors[order].T)
    ends = np.searchsorted(pivots[order[:m]], range(4)).tolist()
    chunks = [
        (pivot, ends[pivot] + rows)
        for pivot in range(3)
        for rows in row_chunks(ends[pivot + 1] - ends[pivot], 8 * len(vectors))
    ]
    for pivot, rows in watched(chunks, "chunks of planes"):
        budget.spend(len(rows) * m * _SORT_STEPS)
        check_time()
        later = columns[:, rows[0] :]
        here = later[:, : len(rows), None]
        not_later = np.tri(len(rows), dtype=np.bool_)
        parts = []
        for k in (k for k in range(3) if k != pivot):
            part = later[k] * here[pivot]
            part -= later[pivot] * here[k]
            part[:, : len(rows)][not_later] = 0
            parts.append(part)
        yield parts


def with_top(below: WhitneyMatrix, rank: int) -> WhitneyMatrix:
    """Append the one flat of full rank to the table of a central configuration."""
    rows = []
    for row in below:
        alternating = sum((-1) ** (rank - 1 - j) * value for j, value in enumerate(row))
        rows.append((*row, alternating))
    return (*rows, (0,) * rank + (1,))


def _rank_three_sums(config: Configuration, lines: Groups) -> tuple[int, int, int, int]:
    """Return P, M, K, I of the module's notes."""
    vectors, m = _matrix(config), len(config.vectors)
    points = point_planes = pairs = triples = 0
    members = lines.members()
    for rows in row_chunks(len(lines.row), m):
        check_time()
        first, second = lines.row[rows], lines.first[rows]
        if isinstance(vectors, ModularVectors):
            inside = np.zeros((len(rows), vectors.count), dtype=np.bool_)
            inside[np.arange(len(rows)), first] = True
            for place, line in enumerate(rows.tolist()):
                inside[place, members[line]] = True
            group = _covers(vectors, np.column_stack([first, second]), inside)
            group = replace(group, row=rows[group.row])
        else:
            group = group_ratios(contract_by_two(vectors, first, second), rows)
        group = without_infinity(group, m)
        on_line = lines.size[group.row] + 1
        counted = group.first > lines.first[group.row]
        points += int(counted.sum())
        point_planes += int((on_line + group.size)[counted].sum())
        pairs += len(group.row)
        triples += int(on_line.sum())
    return points, point_planes, pairs, triples


def _about_rank_two(config: Configuration) -> float:
    """Return how many flats of rank 2 there are, from those through a sample of planes."""
    vectors, m = _matrix(config), len(config.vectors)
    if isinstance(vectors, ModularVectors):
        return m * m / 2
    rows = np.linspace(0, m - 1, _SAMPLE).astype(np.intp)
    groups = without_infinity(group_ratios(contract_by_one(vectors, rows), rows), m)
    return float((1 / (groups.size + 1)).sum()) * m / _SAMPLE


def _check_cost(what: str, config: Configuration, pairs: float, bytes: float) -> None:
    """Refuse to compare too many planes with too many flats."""
    # Irrational ones are seen modulo primes, whose number is checked there.
    irrational = largest(config.vectors) == math.inf
    steps = pairs * 2.5 * (30 if irrational else work_factor(config.vectors))
    budget.check_cost(what, "leave out planes", steps=steps, bytes=bytes)


def _matrix(config: Configuration) -> Integers | ModularVectors:
    """Return the vectors, infinity last, as int64 when every minor fits, else as objects.

    Irrational ones are seen modulo primes.
    """
    rows = list(config.vectors)
    if config.infinity is not None:
        rows.append(config.infinity)
    size = largest(rows)
    if size == math.inf:
        return ModularVectors(rows, config.rank)
    bound = 2 * size**2 if config.rank <= 3 else 6 * size**3
    if bound <= _INT64_MAX:
        return np.array(rows, dtype=np.int64)
    return np.array(fast_integers(rows), dtype=object)


def _covers(vectors: ModularVectors, bases: Integers, inside: Integers) -> Groups:
    """Return the vectors outside some flats, grouped by the flats that cover them."""
    covers = vectors.covers(bases, inside)
    last = covers.member[np.cumsum(covers.added) - 1]
    return Groups(covers.below, covers.plane, last, covers.added, covers.member)
