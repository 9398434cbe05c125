"""Bit-packed sign vectors of all faces, by flipping bits along the circles.

A row has one bit for each input plane, in input order, first plane in the highest bit of the
first byte: ``numpy.unpackbits(row, count=m)`` gives them back. On a half circle of circle i every
other circle is crossed once, so the sign vectors of its arcs are running XORs of plane masks; the
other half circle has the opposite signs. No product of normals and points is formed.
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from .crossings import Crossings
from .incidence import Incidence, Indices

#: (rows, ceil(m / 8)) bytes.
PackedSigns: TypeAlias = NDArray[np.uint8]
_Words: TypeAlias = NDArray[np.uint64]


class SignPacker:
    """The sign vectors along the circles of one arrangement.

    Args:
        incidence: the half-edge structure.
        crossings: the crossing orders it was built from.
        plane_circle: (m); the circle of each input plane.
        plane_orientation: (m); +1 where the plane is oriented like its circle, else -1.
    """

    def __init__(
        self,
        incidence: Incidence,
        crossings: Crossings,
        plane_circle: Indices,
        plane_orientation: NDArray[np.int8],
    ) -> None:
        self._incidence = incidence
        self._crossings = crossings
        self._planes = len(plane_circle)
        circles = incidence.circle_count
        members = np.zeros((circles, self._planes), bool)
        members[plane_circle, np.arange(self._planes)] = True
        self._mask = self._words(members)
        turn = np.ones((circles, circles), np.int8)  # the own circle counts as positive
        np.put_along_axis(turn, crossings.order.astype(np.intp), crossings.turn, axis=1)
        self._start = self._words(turn[:, plane_circle] * plane_orientation > 0)
        self._all = self._words(np.ones((1, self._planes), bool))[0]
        self._positive = self._words(plane_orientation[None, :] > 0)[0]

    def _words(self, bits: NDArray[np.bool_]) -> _Words:
        """Pack rows of bits, padded with zeros to whole 64-bit words."""
        padded = np.zeros((len(bits), -(-self._planes // 64) * 64), bool)
        padded[:, : self._planes] = bits
        return np.packbits(padded, axis=1).view(np.uint64)

    def _bytes(self, words: _Words) -> PackedSigns:
        return words.view(np.uint8)[:, : -(-self._planes // 8)]

    def _rows(self, count: int) -> _Words:
        return np.empty((count, self._mask.shape[1]), np.uint64)

    def _half_circle(self, circle: int) -> _Words:
        """Return the signs on the positive side of the arcs after each positive crossing."""
        states: _Words = self._mask.take(self._crossings.order[circle], axis=0, mode="clip")
        states[0] ^= self._start[circle]
        np.bitwise_xor.accumulate(states, axis=0, out=states)
        tied = self._crossings.tied[circle]
        if tied.any():
            states = states[np.append(~tied[1:], True)]
        return states

    def regions(self) -> PackedSigns:
        """Return (F, ceil(m / 8)); a bit is 1 where the sign is +, else the sign is -.

        Complexity: O(c^2 m / 64) word operations.
        """
        incidence = self._incidence
        rows = self._rows(incidence.region_count)
        rows[0] = self._positive
        rows[-1] = self._all ^ rows[0]
        leading = incidence.leader[1:-1] >> 1
        bounds = 1 + np.searchsorted(leading, 2 * incidence.circle_offsets)
        sizes = np.diff(incidence.circle_offsets)
        for circle, size in enumerate(sizes.tolist()):
            begin, end = bounds[circle : circle + 2].tolist()
            if begin == end:
                continue
            places = leading[begin - 1 : end - 1] - 2 * incidence.circle_offsets[circle]
            turned = begin + int(np.searchsorted(places, size))
            states = self._half_circle(circle)
            # The mode "raise" would fill a copy first.
            np.take(states, places % size, axis=0, out=rows[begin:end], mode="clip")
            rows[turned:end] ^= self._all ^ self._mask[circle]
        return self._bytes(rows)

    def arcs(self) -> tuple[PackedSigns, PackedSigns]:
        """Return where the signs are + and where they are -, each (E, ceil(m / 8))."""
        incidence = self._incidence
        positive = self._rows(incidence.arc_count)
        negative = np.empty_like(positive)
        for circle in range(incidence.circle_count):
            others = self._all ^ self._mask[circle]
            states = self._half_circle(circle) if incidence.vertex_count else self._start
            states &= others
            begin, half = 2 * int(incidence.circle_offsets[circle]), len(states)
            positive[begin : begin + half] = states
            negative[begin : begin + half] = states ^ others
            if incidence.vertex_count:
                positive[begin + half : begin + 2 * half] = states ^ others
                negative[begin + half : begin + 2 * half] = states
        return self._bytes(positive), self._bytes(negative)

    def vertices(self) -> tuple[PackedSigns, PackedSigns]:
        """Return where the signs are + and where they are -, each (V, ceil(m / 8))."""
        incidence = self._incidence
        lines = incidence.vertex_count // 2
        positive = self._rows(2 * lines)
        negative = np.empty_like(positive)
        for circle in range(incidence.circle_count if lines else 0):
            slots = slice(*incidence.circle_offsets[circle : circle + 2].tolist())
            after = self._half_circle(circle)
            before = np.vstack([self._start[circle : circle + 1], after[:-1]])
            off = self._all ^ self._mask[circle] ^ (before ^ after)
            here = incidence.slot_line[slots]
            positive[here] = negative[here + lines] = after & off
            negative[here] = positive[here + lines] = ~after & off
        return self._bytes(positive), self._bytes(negative)


def unpack(positive: PackedSigns, negative: PackedSigns, planes: int) -> NDArray[np.int8]:
    """Return rows of signs -1, 0, 1, one column for each input plane."""
    plus = np.unpackbits(positive, axis=1, count=planes).view(np.int8)
    return plus - np.unpackbits(negative, axis=1, count=planes).view(np.int8)
