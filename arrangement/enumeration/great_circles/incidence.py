"""The order of crossings on every great circle, and the half-edge structure that it makes.

**Crossings.** Floats propose their order, exact signs decide. The positive crossings of circle i
with the others lie on a half-open half circle, so their angles lie in an interval of length pi with
one end left out, and grow with their slopes. If in a proposed order no angle exceeds the next, the
order is right. For two neighbours j and k that is certain

* if their slopes as floats differ by more than the error of both, or else
* if ``det(n_i, n_j, n_k) turn_ij turn_ik >= 0``; then equality holds exactly when the crossings
  coincide.

What is sorted are the slopes with other circle and turn written into their last bits, which takes
a third of the time of an indirect sort. Cut to units of ``2^s`` steps of a float, with s at least
`LEAST_BITS`, a float loses less than one unit; and a reliable slope (`ExactSigns`) is within 4
steps of its float. So two of them stand in the order of their units where these differ by two or
more: the floats are then more than one unit apart, 16 steps at least. A circle whose proposal fails
is sorted again by exact determinants.

**Half-edges** are made from these orders by combinatorics only (`build_incidence`); they know no
coordinates. Numbering, for c distinct circles that meet in L lines (pairs of antipodal points):

* vertex v < L is the positive end of line v, vertex v + L is its antipode;
* circle i crosses ``k_i`` lines; *slot* ``circle_offsets[i] + p`` is its p-th positive crossing,
  counterclockwise about its normal. Its 2 k_i crossings are the positive ones and then, in the
  same order, their antipodes;
* arc ``2 circle_offsets[i] + p`` goes counterclockwise from crossing p to crossing p + 1;
* half-edge 2a runs along arc a and has the positive side of the circle on its left; 2a + 1 is its
  twin and runs back;
* region 0 is on the positive side of all circles, the last region is its antipode.

Rank 2 is a pencil: two vertices, and every circle has two arcs between them. Rank 1 is one circle
without a vertex: its one arc is closed, is its own antipode, and has origin -1. Rank 0 has one
region and nothing else.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, cmp_to_key
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from arrangement.console.number_form import ReprMixin
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector
from arrangement.numbers.float_filter import Signs
from arrangement.numbers.linear.rank import triple_product

from .predicates import ExactSigns, FilteredSigns, Integers, along_rows

Indices = NDArray[np.int32]

#: Entries handled at once: temporary arrays this small stay in the cache and are used again.
BLOCK = 1 << 14
#: The least number of last bits of a slope that are overwritten.
LEAST_BITS = 4
#: The slope of a circle with itself, so that it comes last.
_OWN = 2.0**1001


@dataclass(frozen=True, slots=True)
class Crossings:
    """The positive crossings of each of c circles, in counterclockwise order about its normal.

    Attributes:
        order: (c, c - 1); row i lists the other circles.
        turn: (c, c - 1); ``turn_ij`` of `predicates` for the circle j at the same place of `order`.
        tied: (c, c - 1); whether the crossing is the same point as the one before it in the row.
    """

    order: NDArray[np.int32]
    turn: Signs
    tied: NDArray[np.bool_]


def sort_crossings(normals: Integers) -> Crossings:
    """Return the certified order of crossings on each circle.

    Args:
        normals: (c, 3) distinct positive integer vectors, no two parallel; their dtype must obey
            the bound in `predicates`.

    Complexity: O(c^2 log c) time; O(c^2) memory for the result and O(c) for what is temporary.
    """
    count = len(normals)
    shape = (count, max(count - 1, 0))
    result = Crossings(np.empty(shape, np.int32), np.empty(shape, np.int8), np.zeros(shape, bool))
    if not count:
        return result
    signs = FilteredSigns(normals) if normals.dtype == object else ExactSigns(normals)
    for block in budget.chunks(count, max(1, BLOCK // count)):
        _sort_block(signs, block, result)
    return result


def _sort_block(signs: ExactSigns, block: slice, crossings: Crossings) -> None:
    """Fill the rows of `crossings` for a block of circles."""
    slopes, backward = signs.slopes(block)
    count = slopes.shape[1]
    own = np.arange(block.start, block.stop)
    slopes[own - block.start, own] = _OWN
    slopes += 0.0  # one zero, not two
    written = 1 + (count - 1).bit_length()
    bits = max(LEAST_BITS, written)
    keys = slopes.view(np.int64)
    keys &= -1 << bits
    keys |= 2 * np.arange(count)
    keys |= backward
    slopes.sort(axis=1)
    keys = keys[:, :-1]
    last = keys.astype(np.int32) & np.int32((1 << written) - 1)
    order, turn, tied = crossings.order[block], crossings.turn[block], crossings.tied[block]
    order[...] = last >> 1
    turn[...] = 1 - 2 * (last & 1)
    near = np.abs(np.diff(keys >> bits, axis=1)) < 2 if signs.reliable else ~tied[:, 1:]
    rows, columns = np.divmod(np.flatnonzero(near), count - 2)
    ascents = _ascents(signs, own, order, turn, rows, columns)
    if wrong := sorted(set(rows[ascents < 0].tolist())):
        normals = signs.normals.tolist()
        for row in wrong:
            _sort_exactly(normals, block.start + row, order[row], turn[row])
        ascents = _ascents(signs, own, order, turn, rows, columns)
    tied[rows, columns + 1] = ascents == 0


def _ascents(
    signs: ExactSigns,
    own: NDArray[np.integer],
    order: NDArray[np.int32],
    turn: Signs,
    rows: NDArray[np.integer],
    columns: NDArray[np.integer],
) -> Signs:
    """Return ``sign det(n_i, n_j, n_k) turn_ij turn_ik`` for neighbours j and k at some places."""
    here, there = (rows, columns), (rows, columns + 1)
    determinants = signs.determinants(own[rows], order[here], order[there])
    ascents: Signs = determinants * turn[here] * turn[there]
    return ascents


def _sort_exactly(
    normals: list[IntegerVector], circle: int, order: NDArray[np.int32], turn: Signs
) -> None:
    """Sort a row of `Crossings` in place by exact determinants."""

    def compare(left: tuple[int, int], right: tuple[int, int]) -> Any:
        (j, turn_j), (k, turn_k) = left, right
        return triple_product(normals[circle], normals[k], normals[j]) * turn_j * turn_k

    row = sorted(zip(order.tolist(), turn.tolist(), strict=True), key=cmp_to_key(compare))
    order[...], turn[...] = np.array(row).T


@dataclass(frozen=True, eq=False, repr=False)
class Incidence(ReprMixin):
    """Vertices, arcs and regions of a great-circle arrangement, as int32 arrays.

    Attributes:
        circle_offsets: (c + 1); where the slots of each circle begin.
        slot_line: (S); the line at each slot.
        line_offsets: (L + 1); where the ring of each line begins in `line_slots`.
        line_slots: (S); the slots at each line, one for each circle through it, in the
            counterclockwise order in which the circles leave its positive vertex.
        origin: (2E); the vertex where a half-edge starts (-1 on the closed arc of rank 1).
        next: (2E); the half-edge that follows, with the same region on its left.
        region: (2E); the region on the left of a half-edge.
        leader: (F); one half-edge of each region (-1 in rank 0).
    """

    circle_offsets: Indices
    slot_line: Indices
    line_offsets: Indices
    line_slots: Indices
    origin: Indices
    next: Indices
    region: Indices
    leader: Indices

    def __post_init__(self) -> None:
        for array in vars(self).values():
            array.flags.writeable = False

    @property
    def circle_count(self) -> int:
        """The number of distinct circles."""
        return len(self.circle_offsets) - 1

    @property
    def vertex_count(self) -> int:
        """The number of vertices, two for each line."""
        return 2 * len(self.line_offsets) - 2

    @property
    def arc_count(self) -> int:
        """The number of arcs."""
        return len(self.next) // 2

    @property
    def region_count(self) -> int:
        """The number of regions."""
        return len(self.leader)

    @cached_property
    def arc_circle(self) -> Indices:
        """(E); the circle of each arc."""
        if self.arc_count == 1:
            return np.zeros(1, np.int32)
        circles = np.arange(self.circle_count, dtype=np.int32)
        return np.repeat(circles, 2 * np.diff(self.circle_offsets))

    @cached_property
    def slot_circle(self) -> Indices:
        """(S); the circle of each slot."""
        circles = np.arange(self.circle_count, dtype=np.int32)
        return np.repeat(circles, np.diff(self.circle_offsets))

    @cached_property
    def arc_antipode(self) -> Indices:
        """(E); the arc opposite to each arc."""
        arcs = np.arange(self.arc_count, dtype=np.int32)
        if self.arc_count == 1:
            return arcs
        start = 2 * self.circle_offsets[self.arc_circle]
        size = np.diff(self.circle_offsets)[self.arc_circle]
        opposite: Indices = start + (arcs - start + size) % (2 * size)
        return opposite

    @cached_property
    def region_antipode(self) -> Indices:
        """(F); the region opposite to each region. The antipodal map exchanges an arc's sides."""
        if self.arc_count == 0:
            return np.zeros(1, np.int32)
        arc, side = self.leader >> 1, self.leader & 1
        opposite: Indices = self.region[2 * self.arc_antipode[arc] + 1 - side]
        return opposite

    @cached_property
    def region_degree(self) -> Indices:
        """(F); the number of arcs around each region."""
        return np.bincount(self.region, minlength=self.region_count).astype(np.int32)

    def crossings(self, circle: int) -> Indices:
        """Return the vertices on a circle, counterclockwise about its normal."""
        positive = self.slot_line[self.circle_offsets[circle] : self.circle_offsets[circle + 1]]
        return np.concatenate([positive, positive + np.int32(self.vertex_count // 2)])

    def circles_at(self, vertex: int) -> Indices:
        """Return the circles through a vertex, counterclockwise as they leave it."""
        lines = self.vertex_count // 2
        line = vertex % lines
        ring = self.line_slots[self.line_offsets[line] : self.line_offsets[line + 1]]
        circles = np.searchsorted(self.circle_offsets, ring, side="right").astype(np.int32) - 1
        return circles if vertex < lines else circles[::-1]

    def boundary(self, region: int) -> Indices:
        """Return the half-edges around a region, counterclockwise, beginning with its leader."""
        cycle = [int(self.leader[region])]
        if cycle[0] < 0:
            return np.empty(0, np.int32)
        while (following := int(self.next[cycle[-1]])) != cycle[0]:
            cycle.append(following)
        return np.array(cycle, np.int32)


#: Lines, slots or half-edges handled at once.
CHUNK = 1 << 16


def build_incidence(crossings: Crossings) -> Incidence:
    """Return the half-edge structure that given crossing orders determine.

    Complexity: O(c^2) time and memory; with E arcs the result takes about 32 E bytes.
    """
    count = len(crossings.order)
    if count < 2:
        return _without_vertices(count)
    slots = _Slots.of(crossings)
    offsets = slots.offsets
    slot_line, line_slots, following, region = (
        np.empty(n * offsets[-1], np.int32) for n in (1, 1, 4, 4)
    )
    line_offsets = [np.zeros(1, np.int32)]
    lines = end = 0
    for rows in _blocks(count):
        stars = _Stars.of(slots, crossings, rows)
        line_offsets.append(stars.number_lines(slot_line, line_slots, lines, end))
        lines += len(line_offsets[-1])
        end = line_offsets[-1][-1] if line_offsets[-1].size else end
        stars.link(following, region)
    del slots, stars  # before the largest arrays are read and written
    leader = _number_regions(region)
    origin = _origin(offsets, slot_line, lines)
    return Incidence(
        offsets,
        slot_line,
        np.concatenate(line_offsets),
        line_slots,
        origin,
        following,
        region,
        leader,
    )


def _without_vertices(circles: int) -> Incidence:
    """Return the structure of no circle, or of a single one with its two sides."""
    none, start = np.empty(0, np.int32), np.zeros(1, np.int32)
    sides = np.arange(2 * circles, dtype=np.int32)
    leader = sides if circles else np.full(1, -1, np.int32)
    origin = np.full(2 * circles, -1, np.int32)
    offsets = np.zeros(circles + 1, np.int32)
    return Incidence(offsets, none, start, none, origin, sides, sides, leader)


class _Arcs(NamedTuple):
    """The arcs that enter and leave the crossings at some slots, and that leave their antipodes.

    The arc that enters an antipode is the one before.
    """

    entering: Indices
    leaving: Indices
    opposite: Indices


@dataclass(frozen=True, slots=True)
class _Slots:
    """Crossings merged where they are tied.

    Attributes:
        offsets: (c + 1); where the slots of each circle begin.
        rank: (S); the place of the slot's circle in the ring of its line. All circles of one line
            leave its positive vertex within half a turn, so the rank of circle i is the number of
            circles j of the line with ``turn_ij < 0``: nothing is sorted here.
        across: (c, c); in row j and column i, the slot of circle j on the line of i and j.
    """

    offsets: Indices
    rank: Indices
    across: Indices

    @classmethod
    def of(cls, crossings: Crossings) -> _Slots:
        count, width = crossings.order.shape
        offsets = np.zeros(count + 1, np.int32)
        np.cumsum(width - crossings.tied.sum(axis=1), out=offsets[1:])
        rank, across = np.empty(offsets[-1], np.int32), np.empty((count, count), np.int32)
        for rows in _blocks(count):
            own = slice(*offsets[[rows.start, rows.stop]].tolist())
            starts = ~crossings.tied[rows].ravel()
            places = crossings.order[rows] + count * np.arange(rows.stop - rows.start)[:, None]
            across[rows].reshape(-1)[places.ravel()] = own.start - 1 + np.cumsum(starts)
            rank[own] = _merge(np.add, crossings.turn[rows].ravel() < 0, starts)
        return cls(offsets, rank, across)

    def arcs(self, slots: Indices, circles: Indices) -> _Arcs:
        """Return the arcs at slots of these circles."""
        start = self.offsets.take(circles, mode="clip")
        size = np.diff(self.offsets).take(circles, mode="clip")
        leaving = slots + start
        entering = leaving - 1
        entering[slots == start] += 2 * size[slots == start]
        return _Arcs(entering, leaving, leaving + size)


def _merge(combine: np.ufunc, entries: NDArray[Any], starts: NDArray[np.bool_]) -> NDArray[Any]:
    """Return entries combined over the runs that begin at starts."""
    if starts.all():
        return entries
    return combine.reduceat(entries, np.flatnonzero(starts), dtype=np.int32)


@dataclass(frozen=True, slots=True)
class _Stars:
    """The stars of lines, as the slots of some circles see them.

    Attributes:
        slots: (s); those slots.
        rank, size: (s); the place of the circle in the ring of the line, and the ring's length.
        others, other_ranks: the same of the other circles' slots, line after line.
        starts: whether an entry of `others` is the first on its line.
        own, before, after: the arcs at the slot itself, and at its neighbours in the ring, whose
            last is followed by the first.
    """

    slots: Indices
    rank: Indices
    size: Indices
    others: Indices
    other_ranks: Indices
    starts: NDArray[np.bool_]
    own: _Arcs
    before: _Arcs
    after: _Arcs

    @classmethod
    def of(cls, slots: _Slots, crossings: Crossings, rows: slice) -> _Stars:
        offsets = slots.offsets[rows.start : rows.stop + 1]
        own = np.arange(offsets[0], offsets[-1])
        order, starts = crossings.order[rows], ~crossings.tied[rows].ravel()
        others = along_rows(np.ascontiguousarray(slots.across[:, rows].T), order).ravel()
        circles, rank = order.ravel(), slots.rank[offsets[0] : offsets[-1]]
        arcs = slots.arcs(own, np.repeat(np.arange(rows.start, rows.stop), np.diff(offsets)))
        if starts.all():  # two circles through each line
            before = after = slots.arcs(others, circles)
            size, other_ranks = np.full_like(rank, 2), 1 - rank
        else:
            runs = np.diff(np.flatnonzero(starts), append=len(starts)).astype(np.int32)
            size, other_ranks = runs + np.int32(1), slots.rank.take(others)
            ring = np.repeat(size, runs)
            ahead = (other_ranks - np.repeat(rank, runs)) % ring
            before, after = (
                slots.arcs(others[at], circles[at]) for at in (ahead == ring - 1, ahead == 1)
            )
        return cls(own, rank, size, others, other_ranks, starts, arcs, before, after)

    def number_lines(
        self, slot_line: Indices, line_slots: Indices, lines: int, filled: int
    ) -> Indices:
        """Write the lines of these slots, and the rings of those that are new; return their ends.

        The least circle of a line numbers it.

        Args:
            slot_line, line_slots: see `Incidence`.
            lines, filled: the number of lines so far, and of slots in their rings.
        """
        least = _merge(np.minimum, self.others, self.starts)
        new = least > self.slots
        numbers = slot_line[self.slots[0] : self.slots[-1] + 1]
        np.cumsum(new, out=numbers)
        numbers += np.int32(lines - 1)
        # Where both circles of a line are among these, what the first one reads is written already.
        numbered = slot_line.take(np.minimum(least, self.slots), mode="clip")
        numbers -= (numbers - numbered) * ~new
        at = np.flatnonzero(new)
        sizes = self.size.take(at)
        ends = np.cumsum(sizes, dtype=np.int32) + np.int32(filled)
        begins = ends - sizes
        line_slots[begins + self.rank.take(at)] = self.slots.take(at)
        if not self.starts.all():
            at = np.flatnonzero(np.repeat(new, self.size - 1))
            begins = np.repeat(begins, sizes - 1)
        line_slots[begins + self.other_ranks.take(at)] = self.others.take(at)
        return ends

    def link(self, following: Indices, region: Indices) -> None:
        """Write the successors of the half-edges at these slots, and hints for `_number_regions`.

        The successor is the half-edge just clockwise of the twin. From a positive vertex with the
        ring ``g_0 .. g_(r-1)`` the half-edges leave counterclockwise as forward g_0 .. forward
        g_(r-1), backward g_0 .. backward g_(r-1); from its antipode each half is reversed.
        """
        first, last = self.rank == 0, self.rank == self.size - 1
        forward, backward, hints = following[0::2], following[1::2], region[0::2]
        onward, back = 2 * self.before.leaving, 2 * self.before.entering + 1
        chosen = back + (onward - back) * first  # np.where takes five times as long here
        forward[self.own.entering] = chosen
        backward[self.own.leaving] = onward + back - chosen
        hints[self.own.leaving] = ~(2 * self.after.entering) * last
        onward = 2 * self.after.opposite
        forward[self.own.opposite - 1] = onward - ~last
        backward[self.own.opposite] = onward - last
        hints[self.own.opposite] = (1 - 2 * self.before.opposite) * first
        own = slice(4 * self.slots[0], 4 * self.slots[-1] + 4)
        np.invert(following[own][1::2], out=region[own][1::2])


def _number_regions(region: Indices) -> Indices:
    """Replace hints by the regions of all half-edges; return a leading half-edge for each region.

    Sweep a half plane around the first coordinate axis, tilted by an infinitesimal so that no
    circle contains the axis. All normals are positive, so every circle is swept forward, and a
    region without an end of the axis inside is met first at one vertex, between two neighbouring
    forward half-edges; the right one of them leads it. The two remaining regions contain an end
    of the axis: they lie on the positive side of all circles (region 0), and on the negative side
    of all (the last).

    Args:
        region: 0 for half-edges that lead; for the others ``~h``, where h is the half-edge beside
            the same region that comes before if both run forward, after if not. So h is nearer to
            the one that leads.
    """
    swept = [np.empty(0, np.int32)]
    regions = 1
    for part in budget.chunks(len(region), CHUNK):
        leads = 2 * np.flatnonzero(region[part][::2] == 0)
        region[part][leads] = np.arange(regions, regions + len(leads))
        swept.append(leads.astype(np.int32) + np.int32(part.start))
        regions += len(leads)
    left, before = len(region), len(region) + 1
    while left < before:  # then those are left that go around the first or the last region
        left, before = 0, left
        for part in budget.chunks(len(region), CHUNK):
            here = region[part]
            places = np.flatnonzero(here < 0)
            hints = ~here.take(places, mode="clip").astype(np.intp)
            here[places] = numbers = region.take(hints, mode="clip")
            left += int(np.count_nonzero(numbers < 0))
    around = np.flatnonzero(region < 0)
    ends = [around[around % 2 == side] for side in (0, 1)]
    region[ends[0]], region[ends[1]] = 0, regions
    return np.concatenate([ends[0][:1], *swept, ends[1][:1]], dtype=np.int32, casting="unsafe")


def _origin(offsets: Indices, slot_line: Indices, lines: int) -> Indices:
    """Return the start of every half-edge: an arc's twin starts where the next arc does."""
    origin = np.empty((2 * len(slot_line), 2), np.int32)
    for start, stop in pairwise(offsets.tolist()):
        arcs = origin[2 * start : 2 * stop]
        arcs[: stop - start, 0] = slot_line[start:stop]
        arcs[stop - start :, 0] = slot_line[start:stop] + np.int32(lines)
        arcs[:-1, 1] = arcs[1:, 0]
        arcs[-1, 1] = arcs[0, 0]
    return origin.ravel()


def _blocks(circles: int) -> Iterator[slice]:
    """Yield slices of circles with about `BLOCK` crossings."""
    return budget.chunks(circles, max(1, BLOCK // circles))
