"""From crossing orders to the half-edge structure: combinatorics only, no coordinates."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .crossings import Crossings
from .incidence import Incidence, Indices

_ONE = np.int32(1)


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
    line_slots = np.empty(len(slot_line), np.int32)
    line_slots[line_offsets[slot_line] + rank] = np.arange(len(slot_line), dtype=np.int32)
    ends = _Ends.of(circle_offsets)
    ring = _Ring.of(rank, multiplicity[slot_line], line_offsets[slot_line], line_slots)
    origin = _origin(ends, slot_line, len(multiplicity))
    following = _next(ends, ring)
    leader, region = _regions(ends, ring, following)
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
        line; the number of circles through each line. All circles of one line leave its positive
        vertex within half a turn, so the rank of circle i is the number of circles j of the line
        with ``turn_ij < 0``: nothing is sorted here.
    """
    count, width = crossings.order.shape
    starts = ~crossings.tied.ravel()
    first_entry = np.nonzero(starts)[0]
    circle_offsets = np.zeros(count + 1, np.int32)
    np.cumsum(starts.reshape(count, width).sum(axis=1), out=circle_offsets[1:])
    slot_circle = np.repeat(np.arange(count, dtype=np.int32), np.diff(circle_offsets))
    others = crossings.order.ravel()
    least = np.minimum.reduceat(others, first_entry)
    rank = np.add.reduceat(crossings.turn.ravel() < 0, first_entry, dtype=np.int32)
    size = np.diff(first_entry, append=len(others)).astype(np.int32)
    owns = least > slot_circle  # the least circle of a line numbers it
    number = np.cumsum(owns, dtype=np.int32) - _ONE
    entry_slot = np.cumsum(starts, dtype=np.int32) - _ONE
    table = np.empty((count, count), np.int32)
    np.put_along_axis(
        table, crossings.order.astype(np.intp), number[entry_slot].reshape(count, width), axis=1
    )
    slot_line = np.where(owns, number, table[least, slot_circle])
    return circle_offsets, slot_line, rank, size[owns] + _ONE


@dataclass(frozen=True, slots=True)
class _Ends:
    """For each slot: the arcs that enter and leave its positive and its negative crossing."""

    entering: Indices
    leaving: Indices
    entering_antipode: Indices
    leaving_antipode: Indices

    @classmethod
    def of(cls, circle_offsets: Indices) -> _Ends:
        size = np.diff(circle_offsets)
        leaving = np.arange(circle_offsets[-1], dtype=np.int32)
        leaving += np.repeat(circle_offsets[:-1], size)
        opposite = leaving + np.repeat(size, size)
        entering = leaving - _ONE
        entering[circle_offsets[:-1]] += 2 * size
        return cls(entering, leaving, opposite - _ONE, opposite)


@dataclass(frozen=True, slots=True)
class _Ring:
    """For each slot: its neighbours in the ring of its line, and whether it is first or last."""

    before: Indices
    after: Indices
    first: NDArray[np.bool_]
    last: NDArray[np.bool_]

    @classmethod
    def of(cls, rank: Indices, size: Indices, start: Indices, line_slots: Indices) -> _Ring:
        first, last = rank == 0, rank == size - _ONE
        before = line_slots[start + np.where(first, size, rank) - _ONE]
        after = line_slots[start + np.where(last, -1, rank) + _ONE]
        return cls(before, after, first, last)


def _origin(ends: _Ends, slot_line: Indices, lines: int) -> Indices:
    """Return the start of every half-edge: forward ones leave a crossing, their twins enter it."""
    origin = np.empty(4 * len(slot_line), np.int32)
    antipode = slot_line + np.int32(lines)
    origin[2 * ends.leaving] = slot_line
    origin[2 * ends.entering + 1] = slot_line
    origin[2 * ends.leaving_antipode] = antipode
    origin[2 * ends.entering_antipode + 1] = antipode
    return origin


def _next(ends: _Ends, ring: _Ring) -> Indices:
    """Return the successor of every half-edge: the one just clockwise of its twin.

    From a positive vertex with the ring ``g_0 .. g_(r-1)`` the half-edges leave counterclockwise
    as forward g_0 .. forward g_(r-1), backward g_0 .. backward g_(r-1); from its antipode each
    half is reversed.
    """
    following = np.empty(4 * len(ring.before), np.int32)
    onward, back = 2 * ends.leaving, 2 * ends.entering + 1
    forward, backward = onward[ring.before], back[ring.before]
    following[2 * ends.entering] = np.where(ring.first, forward, backward)
    following[2 * ends.leaving + 1] = np.where(ring.first, backward, forward)
    onward, back = 2 * ends.leaving_antipode, 2 * ends.entering_antipode + 1
    forward, backward = onward[ring.after], back[ring.after]
    following[2 * ends.entering_antipode] = np.where(ring.last, forward, backward)
    following[2 * ends.leaving_antipode + 1] = np.where(ring.last, backward, forward)
    return following


def _regions(ends: _Ends, ring: _Ring, following: Indices) -> tuple[Indices, Indices]:
    """Return a leading half-edge for each region, and the region of each half-edge.

    Sweep a half plane around the first coordinate axis, tilted by an infinitesimal so that no
    circle contains the axis. All normals are positive, so every circle is swept forward, and a
    region without an end of the axis inside is met first at one vertex, between two neighbouring
    forward half-edges. The two remaining regions contain an end of the axis: they lie on the
    positive side of all circles (region 0), and on the negative side of all (the last).
    """
    leads = np.zeros(len(following) // 2, bool)
    leads[ends.leaving] = ~ring.last
    leads[ends.leaving_antipode] = ~ring.first
    swept = np.nonzero(leads)[0].astype(np.int32)
    region = np.full(len(following), -1, np.int32)
    number = np.arange(1, len(swept) + 1, dtype=np.int32)
    start = current = 2 * swept
    while len(current):
        region[current] = number
        current = following[current]
        open_ = current != start
        current, start, number = current[open_], start[open_], number[open_]
    ends_of_axis = [2 * int(region[0::2].argmin()), 2 * int(region[1::2].argmin()) + 1]
    region[0::2][region[0::2] < 0] = 0
    region[1::2][region[1::2] < 0] = len(swept) + 1
    leader = np.concatenate([ends_of_axis[:1], 2 * swept, ends_of_axis[1:]]).astype(np.int32)
    return leader, region
