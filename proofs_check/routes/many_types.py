"""Dual graphs of many types at once, from chirotopes alone, for sweeps over all types.

Sets of elements are bits of integers, and a covector is the set of elements where it is positive
with the set where it is zero. A *flag* is a vertex (cocircuit), an edge at it and one of the two
regions at the edge. Composed from cocircuits, flags give every region, facet and ray.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from arrangement.library.census.chirotopes import Integers, Signs, alternating
from arrangement.numbers.float_filter import Booleans

#: Types that are worked on together.
_TOGETHER = 50
_PLACE_OF_BIT = np.zeros(1 << 12, dtype=np.intp)
_PLACE_OF_BIT[1 << np.arange(12)] = np.arange(12)


class Flags(NamedTuple):
    """All flags of N chirotopes of n elements, some of them more than once.

    Attributes:
        element: (K,), on which the edge lies.
        vertex, through: (N, K), where the vertex is positive, and where it is zero.
        edge: (N, K), where the edge is positive.
    """

    element: Integers
    vertex: Integers
    through: Integers
    edge: Integers


def flags(signs: Signs, n: int) -> Flags:
    """Return the vertices with the edges at them: those of the pairs (e, f), in four ways.

    The vertex of e and f is a cocircuit X; with g outside, that of e and g says how the lines
    through the vertex are crossed along e, so it is composed with X.
    """
    chi = alternating(signs, n)
    e, f = np.nonzero(~np.eye(n, dtype=bool))
    at = chi[:, e, f]  # (N, pairs, n)
    outside = (at != 0).argmax(2)
    along = np.take_along_axis(chi[:, e], outside[:, :, None, None], 2)[:, :, 0]
    powers = 1 << np.arange(n)
    zero = (at == 0) @ powers
    ways = [(s, t) for s in (1, -1) for t in (1, -1)]
    vertex = [(s * at > 0) @ powers for s, _ in ways]
    edge = [(np.where(at == 0, t * along, s * at) > 0) @ powers for s, t in ways]
    return Flags(np.tile(e, 4), np.hstack(vertex), np.tile(zero, 4), np.hstack(edge))


def f_vectors(signs: Signs, n: int) -> Integers:
    """Return rays, facets and regions of each chirotope, counted one by one: (N, 3)."""
    all_flags = flags(signs, n)
    regions = np.hstack([all_flags.edge, all_flags.edge | (1 << all_flags.element)])
    facets = all_flags.edge + (all_flags.element << n)
    rays = all_flags.vertex + (all_flags.through << n)
    return np.stack([_different(x) for x in (rays, facets, regions)], 1)


def _different(rows: Integers) -> Integers:
    numbers: Integers = (np.diff(np.sort(rows, axis=1), axis=1) > 0).sum(1) + 1
    return numbers


def cycle_bases_are_faces(signs: Signs, n: int) -> Booleans:
    """Return whether all face boundaries but a longest one are a minimum cycle basis: (N,).

    They are a basis, as the graph is planar. A basis is minimum exactly when each cycle of
    Horton's candidates is at least as long as all members that it is the sum of; these are the
    faces on its side away from the face left out. No cycle is shorter than 4, so faces with 4
    edges need no look.
    """
    all_flags = flags(signs, n)
    most, minimum = np.bitwise_count(all_flags.through).max(1), np.ones(len(signs), dtype=bool)
    for lines in np.unique(most[most > 2]):
        chosen = np.flatnonzero(most == lines)
        for rows in np.array_split(chosen, -(-len(chosen) // _TOGETHER)):
            minimum[rows] = _are_minimum(
                Flags(all_flags.element, *(x[rows] for x in all_flags[1:])), n
            )
    return minimum


def _are_minimum(all_flags: Flags, n: int) -> Booleans:
    edges = _pad(all_flags.edge + (all_flags.element << n))
    edge, element = edges & ((1 << n) - 1), edges >> n
    lengths, crossed = _ways(all_flags, edge, element, n)
    return _no_shorter(edge, element, crossed, lengths, n)


def _pad(keys: Integers) -> Integers:
    """Return the different numbers of each row, padded by repeating the smallest."""
    rows = np.sort(keys, axis=1)
    rows[:, 1:][rows[:, 1:] == rows[:, :-1]] = -1
    most = (rows >= 0).sum(1).max()
    rows = np.sort(rows, axis=1)[:, -most:]
    return np.where(rows < 0, rows[:, -1:], rows)


def _ways(all_flags: Flags, edge: Integers, element: Integers, n: int) -> tuple[Integers, Integers]:
    """Lay ways from a largest face of each type to all others with over 4 edges, along lines.

    Returns the numbers of edges of those faces (N, R), 0 where there are fewer, and for each edge
    the set of the faces whose way crosses it (N, edges).
    """
    rays = _pad(all_flags.vertex + (all_flags.through << n))
    positive, zero = rays & ((1 << n) - 1), rays >> n
    degree = 2 * np.bitwise_count(zero).astype(np.int64)
    degree[:, 1:][rays[:, 1:] == rays[:, :-1]] = 0  # padded
    last = degree.argmax(1)[:, None]
    start, begin = np.take_along_axis(positive, last, 1), np.take_along_axis(zero, last, 1)
    np.put_along_axis(degree, last, 0, 1)
    order = np.argsort(-degree, axis=1, kind="stable")
    order = order[:, : max(1, (degree > 4).sum(1).max())]
    lengths = np.take_along_axis(degree, order, 1)
    lengths[lengths <= 4] = 0
    goal, end = np.take_along_axis(positive, order, 1), np.take_along_axis(zero, order, 1)
    common = begin & end
    one = np.where(common, _lowest(common), _lowest(begin))
    other = _lowest(end)
    pair = np.zeros((1 << n, 1 << n), dtype=np.intp)
    e, f = np.nonzero(~np.eye(n, dtype=bool))
    pair[1 << e, 1 << f] = np.arange(len(e))
    turn = np.where(common, goal, np.take_along_axis(all_flags.vertex, pair[one, other], 1))
    bend = np.where(common, end, np.take_along_axis(all_flags.through, pair[one, other], 1))
    ways = np.zeros(edge.shape, dtype=np.int64)
    line = 1 << element
    for k in range(order.shape[1]):
        first = _is_between(line, edge, one[:, k], start[:, 0], begin[:, 0], turn[:, k], bend[:, k])
        second = _is_between(line, edge, other[:, k], turn[:, k], bend[:, k], goal[:, k], end[:, k])
        crossing = first ^ (second & (common[:, k] == 0)[:, None])
        ways |= crossing.astype(np.int64) << k
    return lengths, ways


def _is_between(line: Integers, edge: Integers, on: Integers, *ends: Integers) -> Booleans:
    """Return which edges lie on one line between two of its vertices, (N,) each.

    There the sides of the lines through either vertex are those of the other one. Between a vertex
    and its opposite one of both halves is taken.
    """
    one, at_one, other, at_other = ends
    opposite = (at_one == at_other)[:, None]
    near, far = (_lowest(zero & ~on)[:, None] for zero in (at_one, at_other))
    within = ((edge ^ other[:, None]) & near) == 0
    half = (edge & near) == 0
    within &= ((edge ^ one[:, None]) & far) == 0
    between: Booleans = (line == on[:, None]) & np.where(opposite, half, within)
    return between


def _lowest(sets: Integers) -> Integers:
    return sets & -sets


def _no_shorter(
    edge: Integers, element: Integers, crossed: Integers, lengths: Integers, n: int
) -> Booleans:
    """Return whether each of Horton's candidates is no shorter than any face that it encloses.

    Every cycle has a region with an even number of positive signs, so ways start there.
    """
    total, size = len(edge), 1 << n
    over, types = edge | (1 << element), np.arange(total)[:, None]
    walls = np.zeros((total, size), dtype=np.int32)
    np.bitwise_or.at(walls, (types, edge), 1 << element)
    np.bitwise_or.at(walls, (types, over), 1 << element)
    crossing = np.zeros((n, total, size), dtype=np.int32)
    crossing[element, types, edge] = crossing[element, types, over] = crossed
    regions = _pad(np.hstack([edge, over]))
    place = np.zeros((total, size), dtype=np.int32)
    place[types, regions] = np.arange(regions.shape[1])
    even = np.bitwise_count(regions) % 2 == 0
    starts = _pad(np.where(even, regions, regions[types[:, 0], even.argmax(1)][:, None]))
    apart = starts[:, :, None] ^ regions[:, None]
    toward = _lowest(np.take_along_axis(walls, regions, 1)[:, None] & apart)
    # Distances in the graph are numbers of different signs: some wall leads nearer.
    shortest: Booleans = ((toward != 0) | (apart == 0)).all((1, 2))
    of, cells = types[:, :, None], np.broadcast_to(regions[:, None], apart.shape)
    way = crossing[_PLACE_OF_BIT[toward], of, cells]
    way[toward == 0] = 0
    parent = place[of, cells ^ toward].astype(np.intp)
    reach = int(lengths.max()) // 2 - 1  # candidates that go further are as long as every face
    for _ in range((reach - 1).bit_length()):
        way = way ^ np.take_along_axis(way, parent, 2)
        parent = np.take_along_axis(parent, parent, 2)
    distance = np.bitwise_count(apart)
    ends = [
        np.broadcast_to(place[types, x][:, None], (*starts.shape, len(x.T))) for x in (edge, over)
    ]
    one, other = (np.take_along_axis(distance <= reach, x, 2) for x in ends)
    t, start, across = np.nonzero(one & other)
    one, other = (x[t, 0, across] for x in ends)
    length = 1 + distance[t, start, one] + distance[t, start, other]
    longer = (
        (lengths[:, None] > np.arange(2 * n + 2)[:, None]) << np.arange(lengths.shape[1])
    ).sum(2)
    enclosed = way[t, start, one] ^ way[t, start, other] ^ crossed[t, across]
    shortest[t[enclosed & longer[t, length] != 0]] = False
    return shortest


def have_weights(signs: Signs, n: int) -> Booleans:
    """Return whether weights between 0 and 1/2 on all edges can sum to 1 at every region: (N,)."""
    all_flags = flags(signs, n)
    ends = np.stack([all_flags.edge, all_flags.edge | (1 << all_flags.element)], 2).tolist()
    return np.array([edges_have_weights(edges) for edges in ends])


def edges_have_weights(edges: Iterable[Sequence[int]]) -> bool:
    """Return the same for a connected graph, given as pairs of sets (bits) of unlike parity.

    Twice the weights at a corner of all weights from 0 to 1/2 are 0 or 1: they choose two edges at
    every vertex. Take one such choice, and direct its edges to the even ends, the others to the
    odd ones. Turning a directed cycle round gives the other choices. So an edge has weights
    strictly between exactly when a directed cycle contains it, and all edges have when every
    vertex reaches every other one.
    """
    near: dict[int, set[int]] = {}
    for a, b in edges:
        even, odd = (b, a) if a.bit_count() % 2 else (a, b)
        near.setdefault(even, set()).add(odd)
    chosen: dict[int, set[int]] = {odd: set() for odds in near.values() for odd in odds}
    if len(chosen) != len(near):
        return False
    if not all(_choose(even, near, chosen, set()) for even in near for _ in range(2)):
        return False
    ahead: dict[int, list[int]] = {vertex: [] for vertex in (*near, *chosen)}
    back: dict[int, list[int]] = {vertex: [] for vertex in ahead}
    for even, odds in near.items():
        for odd in odds:
            start, end = (odd, even) if even in chosen[odd] else (even, odd)
            ahead[start].append(end)
            back[end].append(start)
    return _reaches_all(ahead) and _reaches_all(back)


def _choose(
    even: int, near: dict[int, set[int]], chosen: dict[int, set[int]], seen: set[int]
) -> bool:
    """Choose one more edge at a vertex, where needed by changing the choices of others."""
    for odd in near[even] - seen:
        ends = chosen[odd]
        if even in ends or odd in seen:
            continue
        seen.add(odd)
        if len(ends) < 2:
            ends.add(even)
            return True
        for other in tuple(ends):
            if _choose(other, near, chosen, seen):
                ends.remove(other)
                ends.add(even)
                return True
    return False


def _reaches_all(arcs: dict[int, list[int]]) -> bool:
    stack = [next(iter(arcs))]
    seen = set(stack)
    while stack:
        new = set(arcs[stack.pop()]) - seen
        seen |= new
        stack.extend(new)
    return len(seen) == len(arcs)
