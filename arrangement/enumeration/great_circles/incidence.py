"""The half-edge structure of a great-circle arrangement. It knows topology only, no coordinates.

Numbering, for c distinct circles that meet in L lines (pairs of antipodal points):

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

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from arrangement.console.number_form import ReprMixin

Indices = NDArray[np.int32]


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
