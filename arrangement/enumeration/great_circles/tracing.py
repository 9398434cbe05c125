"""From crossing orders to the half-edge structure: combinatorics only, no coordinates."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from .crossings import Crossings
from .incidence import Incidence, Indices

#: Slots or regions handled at once.
CHUNK = 1 << 16

_ONE = np.int32(1)
_Flags: TypeAlias = NDArray[np.bool_]


def build_incidence(crossings: Crossings) -> Incidence:
    """Return the half-edge structure that given crossing orders determine.

    Complexity: O(c^2) time and memory; with E arcs the result takes about 32 E bytes.
    """
    circles = len(crossings.order)
    if circles < 2:
        return _without_vertices(circles)
    circle_offsets, slot_line, rank, multiplicity = _lines(crossings)
    line_offsets = np.zeros(len(multiplicity) + 1, np.int32)
    np.cumsum(multiplicity, out=line_offsets[1:])
    ring = _Ring.of(slot_line, rank, multiplicity, line_offsets)
    ends = _Ends.of(circle_offsets)
    origin = _origin(ends, slot_line, len(multiplicity))
    following, leads = _next(ends, ring)
    leader, region = _regions(following, leads)
    line_slots = ring.line_slots
    return Incidence(
        circle_offsets, slot_line, line_offsets, line_slots, origin, following, region, leader
    )


def _without_vertices(circles: int) -> Incidence:
    """Return the structure of no circle, or of a single one with its two sides."""
    none, start = np.empty(0, np.int32), np.zeros(1, np.int32)
    sides = np.arange(2 * circles, dtype=np.int32)
    leader = sides if circles else np.full(1, -1, np.int32)
    origin = np.full(2 * circles, -1, np.int32)
    offsets = np.zeros(circles + 1, np.int32)
    return Incidence(offsets, none, start, none, origin, sides, sides, leader)


def _lines(crossings: Crossings) -> tuple[Indices, Indices, Indices, Indices]:
    """Merge tied crossings into slots and give the slots of one line the same number.

    Returns:
        circle_offsets; the line of each slot; the rank of each slot's circle in the ring of its
        line; the number of circles through each line.
    """
    count, width = crossings.order.shape
    circle_offsets = np.zeros(count + 1, np.int32)
    np.cumsum(width - crossings.tied.sum(axis=1), out=circle_offsets[1:])
    slot_line, rank = (np.empty(circle_offsets[-1], np.int32) for _ in range(2))
    multiplicity: list[Indices] = []
    table = np.empty((count, count), np.int32)
    lines = 0
    for rows in chunks(count, max(1, CHUNK // width)):
        slots = slice(*circle_offsets[[rows.start, rows.stop]].tolist())
        numbers, rank[slots], sizes = _lines_of_rows(crossings, rows, table, lines)
        slot_line[slots] = numbers
        multiplicity.append(sizes)
        lines += len(sizes)
    return circle_offsets, slot_line, rank, np.concatenate(multiplicity)


def _lines_of_rows(
    crossings: Crossings, rows: slice, table: Indices, lines: int
) -> tuple[Indices, Indices, Indices]:
    """Return line and rank of the slots of some circles, and the sizes of the lines they number.

    The least circle of a line numbers it; `table[i, j]` is the line of circles i and j where i
    has numbered it. All circles of one line leave its positive vertex within half a turn, so the
    rank of circle i is the number of circles j of the line with ``turn_ij < 0``: nothing is
    sorted here.
    """
    order, starts = crossings.order[rows], ~crossings.tied[rows]
    first_entry = np.nonzero(starts.ravel())[0]
    least = np.minimum.reduceat(order.ravel(), first_entry)
    rank = np.add.reduceat(crossings.turn[rows].ravel() < 0, first_entry, dtype=np.int32)
    size = np.diff(first_entry, append=order.size).astype(np.int32)
    circle = rows.start + first_entry // order.shape[1]
    owns = least > circle
    number = np.cumsum(owns, dtype=np.int32) + np.int32(lines - 1)
    of_entry = np.repeat(number, size).reshape(order.shape)
    np.put_along_axis(table[rows], order.astype(np.intp), of_entry, axis=1)
    return np.where(owns, number, table[least, circle]), rank, size[owns] + _ONE


@dataclass(frozen=True, slots=True)
class _Ends:
    """For each slot: the arcs that enter and leave its crossing, and that leave the antipode.

    The arc that enters the antipode is the one before.
    """

    entering: Indices
    leaving: Indices
    leaving_antipode: Indices

    @classmethod
    def of(cls, circle_offsets: Indices) -> _Ends:
        size = np.diff(circle_offsets)
        leaving = np.arange(circle_offsets[-1], dtype=np.int32)
        leaving += np.repeat(circle_offsets[:-1], size)
        opposite = leaving + np.repeat(size, size)
        entering = leaving - _ONE
        entering[circle_offsets[:-1]] += 2 * size
        return cls(entering, leaving, opposite)


@dataclass(frozen=True, slots=True)
class _Ring:
    """The rings of slots around the lines: rank and size for each slot, and all in ring order."""

    rank: Indices
    size: Indices
    place: Indices
    line_slots: Indices

    @classmethod
    def of(
        cls, slot_line: Indices, rank: Indices, multiplicity: Indices, line_offsets: Indices
    ) -> _Ring:
        size, place = np.empty_like(rank), np.empty_like(rank)
        line_slots = np.empty_like(rank)
        for slots in chunks(len(rank), CHUNK):
            lines = slot_line[slots]
            size[slots] = multiplicity.take(lines)
            place[slots] = line_offsets.take(lines) + rank[slots]
            line_slots[place[slots]] = np.arange(slots.start, slots.stop, dtype=np.int32)
        return cls(rank, size, place, line_slots)

    def around(self, slots: slice) -> tuple[_Flags, Indices, _Flags, Indices]:
        """Return which slots are first, the slots before them, which are last, those after."""
        rank, size, place = self.rank[slots], self.size[slots], self.place[slots]
        first, last = rank == 0, rank == size - _ONE
        before = self.line_slots.take(place + np.where(first, size, 0) - _ONE)
        after = self.line_slots.take(place - np.where(last, size, 0) + _ONE)
        return first, before, last, after


def _origin(ends: _Ends, slot_line: Indices, lines: int) -> Indices:
    """Return the start of every half-edge: forward ones leave a crossing, their twins enter it."""
    origin = np.empty(4 * len(slot_line), np.int32)
    forward, backward = origin[0::2], origin[1::2]
    for slots in chunks(len(slot_line), CHUNK):
        here, there = slot_line[slots], slot_line[slots] + np.int32(lines)
        forward[ends.leaving[slots]] = here
        backward[ends.entering[slots]] = here
        forward[ends.leaving_antipode[slots]] = there
        backward[ends.leaving_antipode[slots] - _ONE] = there
    return origin


def _next(ends: _Ends, ring: _Ring) -> tuple[Indices, _Flags]:
    """Return the successor of every half-edge, and which arcs lead a region (see `_regions`).

    The successor is the half-edge just clockwise of the twin. From a positive vertex with the
    ring ``g_0 .. g_(r-1)`` the half-edges leave counterclockwise as forward g_0 .. forward
    g_(r-1), backward g_0 .. backward g_(r-1); from its antipode each half is reversed.
    """
    following = np.empty(4 * len(ring.rank), np.int32)
    after_forward, after_backward = following[0::2], following[1::2]
    leads = np.zeros(len(after_forward), bool)
    for slots in chunks(len(ring.rank), CHUNK):
        first, before, last, after = ring.around(slots)
        leaving, opposite = ends.leaving[slots], ends.leaving_antipode[slots]
        onward, back = 2 * ends.leaving.take(before), 2 * ends.entering.take(before) + _ONE
        after_forward[ends.entering[slots]] = np.where(first, onward, back)
        after_backward[leaving] = np.where(first, back, onward)
        onward = 2 * ends.leaving_antipode.take(after)
        back = onward - _ONE
        after_forward[opposite - _ONE] = np.where(last, onward, back)
        after_backward[opposite] = np.where(last, back, onward)
        leads[leaving], leads[opposite] = ~last, ~first
    return following, leads


def _regions(following: Indices, leads: _Flags) -> tuple[Indices, Indices]:
    """Return a leading half-edge for each region, and the region of each half-edge.

    Sweep a half plane around the first coordinate axis, tilted by an infinitesimal so that no
    circle contains the axis. All normals are positive, so every circle is swept forward, and a
    region without an end of the axis inside is met first at one vertex, between two neighbouring
    forward half-edges; the right one of them leads it. The two remaining regions contain an end
    of the axis: they lie on the positive side of all circles (region 0), and on the negative side
    of all (the last).
    """
    swept = 2 * np.nonzero(leads)[0].astype(np.int32)
    region = np.full(len(following), -1, np.int32)
    for part in chunks(len(swept), CHUNK):
        _walk(following, region, swept[part], part.start + 1)
    positive, negative = region[0::2], region[1::2]
    at_ends = [2 * int(positive.argmin()), 2 * int(negative.argmin()) + 1]
    _walk(following, region, np.array(at_ends[:1], np.int32), 0)
    _walk(following, region, np.array(at_ends[1:], np.int32), len(swept) + 1)
    return np.concatenate([at_ends[:1], swept, at_ends[1:]], dtype=np.int32), region


def _walk(following: Indices, region: Indices, start: Indices, number: int) -> None:
    """Go around many regions in step, and write their consecutive numbers on the half-edges."""
    numbers = np.arange(number, number + len(start), dtype=np.int32)
    current = start
    while len(current):
        region[current] = numbers
        current = following.take(current)
        left = np.flatnonzero(current != start)
        current, start, numbers = current.take(left), start.take(left), numbers.take(left)


def chunks(total: int, size: int) -> Iterator[slice]:
    """Yield consecutive slices: temporary arrays stay small, whatever the input."""
    for start in range(0, total, size):
        yield slice(start, min(start + size, total))
