"""Great-circle arrangements: the geometry beside the half-edge structure.

Seen from outside the unit sphere, the planes of a central arrangement in R^3 are great circles.
Vertices are rays of the arrangement, arcs its facets, regions its regions.

*Sign vectors* are packed in bits, one for each input plane, in input order, first plane in the
highest bit of the first byte: ``numpy.unpackbits(row, count=m)`` gives them back. On a half circle
of circle i every other circle is crossed once, so the sign vectors of its arcs are running XORs of
plane masks; the other half circle has the opposite signs. No product of normals and points is
formed.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from arrangement.console.number_form import ReprMixin
from arrangement.enumeration.great_circles.incidence import (
    CHUNK,
    Crossings,
    Incidence,
    Indices,
    build_incidence,
    sort_crossings,
)
from arrangement.enumeration.great_circles.predicates import Integers, integer_array
from arrangement.enumeration.great_circles.validation import check_geometry, check_topology
from arrangement.enumeration.reduction import cone, from_dimension, in_dimension, upper_half
from arrangement.enumeration.sequence import Level, Rows
from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, primitive, unoriented
from arrangement.planes.planes import Planes

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


SignVector: TypeAlias = tuple[int, ...]


class SphereArrangement(ReprMixin):
    """All vertices, arcs and regions of a central arrangement in R^3, with their incidence.

    Made by `sphere_arrangement`. Everything is numbered as `Incidence` says. Sign vectors are
    over all input planes in input order; coincident planes share a circle.

    Attributes:
        arrangement: the input.
        incidence: the half-edge structure (topology only).
        circle_normals: the primitive integer normal of each distinct circle, oriented so that its
            first nonzero entry is positive.
        rays: (V, 3); an integer direction vector of each vertex, not always primitive. int64
            where that is proven to be exact, else Python integers.
    """

    repr_fields = ("circle_count", "vertex_count", "arc_count", "region_count")

    def __init__(
        self,
        arrangement: Planes,
        incidence: Incidence,
        crossings: Crossings,
        circle_normals: tuple[IntegerVector, ...],
    ) -> None:
        self.arrangement = arrangement
        self.incidence = incidence
        self.circle_normals = circle_normals
        self._crossings = crossings

    def __repr__(self) -> str:
        return (
            f"<SphereArrangement: {self.circle_count} circles, {self.vertex_count} vertices, "
            f"{self.arc_count} arcs, {self.region_count} regions>"
        )

    @property
    def circle_count(self) -> int:
        """The number of distinct circles."""
        return self.incidence.circle_count

    @property
    def vertex_count(self) -> int:
        """The number of vertices (2 in rank 2, none in rank 1)."""
        return self.incidence.vertex_count

    @property
    def arc_count(self) -> int:
        """The number of arcs."""
        return self.incidence.arc_count

    @property
    def region_count(self) -> int:
        """The number of regions."""
        return self.incidence.region_count

    @property
    def rank(self) -> int:
        """The dimension of the span of the normals."""
        return min(self.circle_count, 2) if self.vertex_count <= 2 else 3

    @cached_property
    def rays(self) -> Integers:
        """The direction of each vertex: the first circle of a line turns into the second."""
        normals, incidence = integer_array(self.circle_normals), self.incidence
        lines = incidence.vertex_count // 2
        rays = np.empty((2 * lines, 3), normals.dtype)
        for part in budget.chunks(lines, CHUNK):
            first = incidence.line_offsets[part]
            left, right = (
                normals[incidence.slot_circle[incidence.line_slots[first + place]]]
                for place in (0, 1)
            )
            rays[part] = np.cross(left, right)
        np.negative(rays[:lines], out=rays[lines:])
        rays.flags.writeable = False
        return rays

    @cached_property
    def plane_circle(self) -> Indices:
        """(m); the circle of each input plane."""
        return np.array(self.arrangement.class_of, np.int32)

    def ray(self, vertex: int) -> IntegerVector:
        """Return the primitive integer direction of a vertex."""
        return primitive(self.rays[vertex].tolist())

    def arc_witness(self, arc: int) -> IntegerVector:
        """Return a primitive integer vector in the relative interior of an arc's cone."""
        if self.rank >= 3:  # an arc is shorter than half a circle
            ends = self.incidence.origin[2 * arc : 2 * arc + 2].tolist()
            return _sum(self.ray(end) for end in ends)
        a, b, c = self.circle_normals[int(self.incidence.arc_circle[arc])]
        if self.rank == 1:
            return primitive((b, -a, 0) if a or b else (1, 0, 0))
        x, y, z = self.ray(int(self.incidence.origin[2 * arc]))
        return primitive((b * z - c * y, c * x - a * z, a * y - b * x))

    def region_witness(self, region: int) -> IntegerVector:
        """Return a primitive integer vector in the interior of a region's cone.

        Three consecutive vertices of a spherical polygon span a triangle inside it; in rank 2 the
        middles of the two arcs of a lune have their sum inside.
        """
        half_edge = int(self.incidence.leader[region])
        if self.rank == 0:
            return (0, 0, 0)
        if self.rank == 1:
            a, b, c = self.circle_normals[0]
            return (a, b, c) if half_edge == 0 else (-a, -b, -c)
        following = self.incidence.next
        if self.rank == 2:
            arcs = (half_edge >> 1, int(following[half_edge]) >> 1)
            return _sum(self.arc_witness(arc) for arc in arcs)
        second = int(following[half_edge])
        corners = self.incidence.origin[[half_edge, second, int(following[second])]].tolist()
        return _sum(self.ray(corner) for corner in corners)

    def region_signs(self, region: int) -> SignVector:
        """Return the sign vector of a region. O(m) exact operations."""
        return self.arrangement.signs_at(self.region_witness(region))

    @cached_property
    def _packer(self) -> SignPacker:
        firsts = [self.circle_normals[circle] for circle in self.arrangement.class_of]
        planes = self.arrangement.integer_planes
        same = [plane[:3] == first for plane, first in zip(planes, firsts, strict=True)]
        orientation = np.where(np.array(same, bool), 1, -1).astype(np.int8)
        return SignPacker(self.incidence, self._crossings, self.plane_circle, orientation)

    @cached_property
    def packed_region_signs(self) -> PackedSigns:
        """(F, ceil(m / 8)); bit 1 for +, bit 0 for -, plane 0 in the highest bit of byte 0.

        Computed when first asked for, by flipping bits along the circles: O(F m / 64).
        """
        return self._packer.regions()

    @cached_property
    def packed_arc_signs(self) -> tuple[PackedSigns, PackedSigns]:
        """Where the signs of each arc are +, and where they are -; each (E, ceil(m / 8))."""
        return self._packer.arcs()

    @cached_property
    def packed_vertex_signs(self) -> tuple[PackedSigns, PackedSigns]:
        """Where the signs of each vertex are +, and where they are -; each (V, ceil(m / 8))."""
        return self._packer.vertices()

    def validate(self) -> None:
        """Check the topology, then the geometry; raise `ArrangementError` naming what failed.

        Complexity: O(E) exact operations and O(E log E) time.
        """
        check_topology(self.incidence)
        if self.vertex_count:
            check_geometry(self.incidence, self.circle_normals, self.rays)


def sphere_arrangement(arrangement: Planes) -> SphereArrangement:
    """Return the great-circle arrangement of a central arrangement in R^3.

    Any rank from 0 to 3; pencils and coincident planes are ordinary input.

    Raises:
        InputError: the space is not R^3, or a plane misses the origin.

    Complexity: with c distinct planes, O(c^2 log c) time and O(c^2) memory, about 50 bytes for
    each of at most 2c(c - 1) arcs. Entries of the primitive normals up to 1 154 000 are handled
    in int64, larger ones in Python integers (two to three times slower at 30 digits).

    >>> from arrangement import Arrangement
    >>> sphere_arrangement(Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]))
    <SphereArrangement: 4 circles, 12 vertices, 24 arcs, 14 regions>
    """
    if arrangement.dimension != 3:
        raise InputError(
            f"the arrangement is in R^{arrangement.dimension}; great circles need R^3: "
            "use Arrangement.faces for other dimensions"
        )
    if not arrangement.is_central:
        plane = next(i for i, offset in enumerate(arrangement.offsets) if offset)
        raise InputError(
            f"plane {plane} misses the origin (offset {arrangement.offsets[plane]}); great "
            "circles need offsets 0: use Arrangement.faces for affine planes"
        )
    circle_normals = tuple(unoriented(plane[:3]) for plane in arrangement.distinct_planes)
    normals = integer_array(circle_normals)
    crossings = sort_crossings(normals)
    return SphereArrangement(arrangement, build_incidence(crossings), crossings, circle_normals)


def _sum(vectors: Iterable[IntegerVector]) -> IntegerVector:
    return primitive([sum(column) for column in zip(*vectors, strict=True)])


def list_faces(planes: Planes) -> tuple[Level, ...]:
    """Return the faces of dimension 0, 1, ..., d.

    Affine planes are the part w > 0 of their cone, which has one dimension and one rank more.
    """
    if not planes.is_central:
        return tuple(upper_half(level) for level in list_faces(cone(planes))[1:])
    if planes.rank == planes.dimension == 3:
        return _levels(sphere_arrangement(planes))
    reduced, columns = in_dimension(planes, 3)
    return from_dimension(_levels(sphere_arrangement(reduced)), planes, columns)


def _levels(sphere: SphereArrangement) -> tuple[Level, ...]:
    """Return the faces of dimension 0, 1, 2, 3.

    A pencil has one line, not two rays: both its vertices have the same sign vector.
    """
    planes, incidence = len(sphere.arrangement), sphere.incidence
    rays = 1 if sphere.rank == 2 else incidence.vertex_count

    def unpacked(packed: tuple[PackedSigns, PackedSigns], rows: Rows) -> NDArray[np.int8]:
        return unpack(packed[0][rows], packed[1][rows], planes)

    def region_signs(rows: Rows) -> NDArray[np.int8]:
        positive = sphere.packed_region_signs[rows]
        return unpack(positive, ~positive, planes)

    def origin(rows: Rows) -> Integers:
        return _homogeneous(np.zeros((1, 3), np.int64)[rows])

    return (
        Level(int(sphere.rank == 3), lambda rows: np.zeros((1, planes), np.int8)[rows], origin),
        Level(
            rays,
            lambda rows: unpacked(sphere.packed_vertex_signs, rows)[:rays],
            lambda rows: _homogeneous(sphere.rays[:rays][rows]),
        ),
        Level(
            incidence.arc_count,
            lambda rows: unpacked(sphere.packed_arc_signs, rows),
            lambda rows: _homogeneous(_arc_points(sphere, rows)),
        ),
        Level(
            incidence.region_count,
            region_signs,
            lambda rows: _homogeneous(_region_points(sphere, rows)),
        ),
    )


def _homogeneous(points: Integers) -> Integers:
    return np.hstack([points, np.ones((len(points), 1), points.dtype)])


def _arc_points(sphere: SphereArrangement, rows: Rows) -> Integers:
    """Return vectors inside the cones of arcs: an arc is shorter than half a circle in rank 3."""
    if sphere.rank < 3:
        arcs = np.arange(sphere.arc_count)[rows].tolist()
        return np.array([sphere.arc_witness(arc) for arc in arcs], object).reshape(-1, 3)
    origin = sphere.incidence.origin
    return sphere.rays[origin[0::2][rows]] + sphere.rays[origin[1::2][rows]]


def _region_points(sphere: SphereArrangement, rows: Rows) -> Integers:
    """Return vectors inside the cones of regions: sums of three corners that follow each other."""
    if sphere.rank < 3:
        regions = np.arange(sphere.region_count)[rows].tolist()
        return np.array([sphere.region_witness(r) for r in regions], object).reshape(-1, 3)
    origin, following = sphere.incidence.origin, sphere.incidence.next
    first: Indices = sphere.incidence.leader[rows]
    second = following[first]
    third = following[second]
    corners: Integers = sphere.rays[origin[first]] + sphere.rays[origin[second]]
    return corners + sphere.rays[origin[third]]
