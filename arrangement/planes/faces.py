"""Faces of an arrangement, and what can be asked of one: its closure is a convex polyhedron.

A face is cheap: signs and a point. Vertices, facets and all that follows from them are worked out
when they are first asked for, from the planes alone (`cones.generators`), whatever engine listed
the face.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

from arrangement.console.number_form import Shown
from arrangement.errors import InputError
from arrangement.numbers.exact import IntegerVector, RationalVector, bits, dot, quotient, shown
from arrangement.numbers.linear.cones import Generators, generators
from arrangement.numbers.linear.rank import determinant, rank
from arrangement.numbers.real_entries import real_vector
from arrangement.numbers.symbolic import to_sympy

from .planes import Planes

if TYPE_CHECKING:
    import sympy

#: Signs that a short form shows.
_SHOWN = 40


@dataclass(frozen=True, repr=False)
class Face(Shown):
    """A face of an arrangement: the set of all points with one sign vector.

    Faces are equal when they are the same set of the same planes, whatever point stands for them.
    A region is a face of dimension d. Where a face contains lines, which it then does in the
    directions that all planes share, it has no vertices; ask `counts.essentialization`.

    Attributes:
        signs: the sign of ``n_i . x - b_i`` for every input plane, in input order.
        dimension: of the face (the whole space minus the rank of its zero planes).
        witness: an exact point of the face.
        planes: the planes that it is a face of.

    >>> from arrangement import Arrangement
    >>> triangle = Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1]).region_at(["1/3", "1/3"])
    >>> triangle
    <Face: ++-, dimension 2>
    >>> [tuple(map(str, vertex)) for vertex in triangle.vertices], str(triangle.volume)
    ([('0', '0'), ('0', '1'), ('1', '0')], '1/2')
    """

    signs: tuple[int, ...]
    dimension: int
    witness: RationalVector = field(compare=False)
    planes: Planes = field(hash=False)

    def __repr__(self) -> str:
        text = "".join("0+-"[sign] for sign in self.signs[:_SHOWN])
        more = "..." * (len(self.signs) > _SHOWN)
        return f"<Face: {text}{more}{', ' * bool(text)}dimension {self.dimension}>"

    @classmethod
    def at(cls, planes: Planes, point: Iterable[Any]) -> Face:
        """Return the face that contains a point of R^d."""
        witness = real_vector(point, "point", planes.field)
        signs = planes.signs_at(witness)
        through = [p[:-1] for p, s in zip(planes.integer_planes, signs, strict=True) if not s]
        return cls(signs, planes.dimension - rank(through), witness, planes)

    def point(self) -> sympy.ImmutableMatrix:
        """Return the witness as a SymPy column; see `to_sympy`."""
        return to_sympy(self.witness)

    def contains(self, point: Iterable[Any], *, closed: bool = False) -> bool:
        """Return whether a point lies in the face; with `closed`, in it or on its boundary."""
        pairs = zip(self.planes.signs_at(point), self.signs, strict=True)
        return all(at == sign or (closed and not at) for at, sign in pairs)

    def separating(self, other: Face) -> tuple[int, ...]:
        """Return the input planes that have this face on one side and the other face beyond."""
        self._check(other)
        pairs = enumerate(zip(self.signs, other.signs, strict=True))
        return tuple(i for i, (one, two) in pairs if one * two < 0)

    def distance(self, other: Face) -> int:
        """Return how many distinct planes separate two faces: of regions, the steps between."""
        return len({self.planes.class_of[plane] for plane in self.separating(other)})

    def compose(self, other: Face) -> Face:
        """Return the composition: the face that is entered on the way from this one to the other.

        Its signs are those of this face, and where these are 0 those of the other face.

        >>> from arrangement import Arrangement
        >>> cross = Arrangement([[1, 0], [0, 1]])
        >>> cross.face_at([1, 0]).compose(cross.face_at([-1, -1]))
        <Face: +-, dimension 2>
        """
        self._check(other)
        step = Fraction(1, 2)  # of the way: less than to where another sign changes
        for i in self.separating(other):
            *normal, offset = self.planes.integer_planes[i]
            here, there = dot(normal, self.witness) - offset, dot(normal, other.witness) - offset
            step = min(step, here / (here - there) / 2)
        pairs = zip(self.witness, other.witness, strict=True)
        return Face.at(self.planes, [x + step * (y - x) for x, y in pairs])

    def inequalities(
        self, symbols: Iterable[sympy.Symbol] | None = None
    ) -> tuple[sympy.core.relational.Relational, ...]:
        """Return SymPy conditions for the points of the face, none of which is redundant.

        One inequality for each facet, and as many equations as the codimension, in the order of
        the planes.

        Args:
            symbols: as in `Planes.equations`.

        >>> from arrangement import Arrangement
        >>> Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1]).region_at([2, 2]).inequalities()
        (x > 0, y > 0, x + y > 1)
        """
        import sympy

        chosen = list(self.walls)
        basis: list[IntegerVector] = []
        for i, (plane, sign) in enumerate(zip(self.planes.integer_planes, self.signs, strict=True)):
            if not sign and rank([*basis, plane]) > len(basis):
                basis.append(plane)
                chosen.append(i)
        kinds = {0: sympy.Eq, 1: sympy.StrictGreaterThan, -1: sympy.StrictLessThan}
        equations = self.planes.equations(symbols)
        return tuple(
            kinds[self.signs[i]](equations[i].lhs, equations[i].rhs, evaluate=False)
            for i in sorted(chosen)
        )

    @property
    def is_bounded(self) -> bool:
        """Whether the face has an end in every direction."""
        found, lines = self._generators
        return not lines and all(x[-1] for x in found)

    @property
    def vertices(self) -> tuple[RationalVector, ...]:
        """The corners of the closure; none if it contains a line."""
        found, lines = self._generators
        return tuple(
            tuple(quotient(x, point[-1]) for x in point[:-1])
            for point in found
            if point[-1] and not lines
        )

    @property
    def rays(self) -> tuple[IntegerVector, ...]:
        """The directions of the unbounded edges: primitive, one for each, modulo `lines`."""
        return tuple(x[:-1] for x in self._generators[0] if not x[-1])

    @property
    def lines(self) -> tuple[IntegerVector, ...]:
        """A basis of the directions of the lines in the face."""
        return tuple(x[:-1] for x in self._generators[1])

    @property
    def walls(self) -> tuple[int, ...]:
        """For each facet the first input plane that cuts it out."""
        return tuple(plane for _, plane in self._walls)

    @property
    def facets(self) -> tuple[Face, ...]:
        """The faces of one dimension less on the boundary, in the order of `walls`."""
        return tuple(self._part(wall) for wall, _ in self._walls)

    @property
    def is_simplicial(self) -> bool:
        """Whether the normals of its facets are independent, so that it is a simplicial cone."""
        normals = [self.planes.integer_planes[plane][:-1] for plane in self.walls]
        zeros = [
            p[:-1] for p, s in zip(self.planes.integer_planes, self.signs, strict=True) if not s
        ]
        return rank([*normals, *zeros]) == len(normals) + rank(zeros)

    def faces(self) -> tuple[Face, ...]:
        """Return all faces of the arrangement in the closure, lowest first, itself last."""
        return tuple(self._part(mask) for mask in sorted(self._masks, key=self._masks.__getitem__))

    @property
    def f_vector(self) -> tuple[int, ...]:
        """The number of faces of dimension 0, 1, ... of the closure; the last one is itself."""
        dimensions = list(self._masks.values())
        return tuple(dimensions.count(k) for k in range(self.dimension + 1))

    @property
    def volume(self) -> Fraction:
        """The exact volume of a bounded region, from a triangulation of its closure.

        Raises:
            InputError: if the face is unbounded, or of a dimension less than d.
        """
        if self.dimension < self.planes.dimension or not self.is_bounded:
            raise InputError(
                f"{self!r} of R^{self.planes.dimension} is {'' if self.is_bounded else 'un'}bounded"
                "; only bounded regions have a volume (`bounded_regions` lists them)"
            )
        corners = self._generators[0]
        walls = [wall for wall, _ in self._walls]
        return sum(
            (
                quotient(abs(determinant(simplex)), math.prod(row[-1] for row in simplex))
                for simplex in (
                    [corners[i] for i in chosen] for chosen in _simplices(self._all, walls)
                )
            ),
            Fraction(0),
        ) / math.factorial(self.dimension)

    def _check(self, other: Face) -> None:
        if not isinstance(other, Face) or other.planes != self.planes:
            raise InputError(f"{shown(other)} is no face of these planes: {self.planes!r}")

    @cached_property
    def _generators(self) -> Generators:
        """The closure's vertices ``(X, W)`` and directions ``(X, 0)``, and its lines."""
        sides: dict[int, list[IntegerVector]] = {0: [], 1: [], -1: []}
        for members in self.planes.distinct:
            *normal, offset = self.planes.integer_planes[members[0]]
            side = self.signs[members[0]]
            sides[side].append(tuple((side or 1) * x for x in (*normal, -offset)))
        return generators(sides[1] + sides[-1], sides[0], self.planes.dimension + 1, finite=True)

    @property
    def _all(self) -> int:
        return (1 << len(self._generators[0])) - 1

    @cached_property
    def _touching(self) -> tuple[int, ...]:
        """For each class of planes the generators in it, as bits."""
        firsts = self.planes.distinct_planes
        return tuple(
            sum(
                1 << j
                for j, x in enumerate(self._generators[0])
                if dot(plane[:-1], x[:-1]) == plane[-1] * x[-1]
            )
            for plane in firsts
        )

    @cached_property
    def _finite(self) -> int:
        """The generators that are points, as bits."""
        return sum(1 << j for j, x in enumerate(self._generators[0]) if x[-1])

    @cached_property
    def _walls(self) -> tuple[tuple[int, int], ...]:
        """For each facet its generators, as bits, and the first plane that cuts it out."""
        first = {
            mask: members[0]
            for mask, members in reversed(
                list(zip(self._touching, self.planes.distinct, strict=True))
            )
            if mask & self._finite and mask != self._all
        }
        return tuple(sorted(((m, first[m]) for m in _maximal(first)), key=lambda wall: wall[1]))

    @cached_property
    def _masks(self) -> dict[int, int]:
        """The generators of every face of the closure, as bits, and its dimension."""
        rows, lines = self._generators
        found = {self._all: self.dimension}
        waiting = [self._all]
        while waiting:
            mask = waiting.pop()
            for wall, _ in self._walls:
                part = mask & wall
                if part & self._finite and part not in found:
                    found[part] = rank([*(rows[j] for j in bits(part)), *lines]) - 1
                    waiting.append(part)
        return found

    def _part(self, mask: int) -> Face:
        """Return the face of the closure that some generators span."""
        rows = [self._generators[0][j] for j in bits(mask)]
        *total, scale = map(sum, zip(*rows, strict=True))
        return Face.at(self.planes, [quotient(x, scale) for x in total])


def _maximal(masks: Iterable[int]) -> list[int]:
    """Return the masks that are part of no other one."""
    kept: list[int] = []
    for mask in sorted(masks, key=int.bit_count, reverse=True):
        if not any(mask & other == mask for other in kept):
            kept.append(mask)
    return kept


def _simplices(mask: int, walls: Sequence[int]) -> Iterator[tuple[int, ...]]:
    """Yield the simplices of a triangulation of a face: pyramids over facets off one corner."""
    apex = mask & -mask
    corner = apex.bit_length() - 1
    if mask == apex:
        yield (corner,)
    for facet in _maximal({mask & wall for wall in walls if mask & ~wall and mask & wall}):
        if not facet & apex:
            for simplex in _simplices(facet, walls):
                yield (corner, *simplex)
