"""Faces of an arrangement, and what can be asked of one: its closure is a convex polyhedron.

A face is cheap: signs and a point. Vertices, facets and all that follows from them are worked out
when they are first asked for, from the planes alone (`Face.closure`), whatever engine listed the
face.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

from arrangement import synonyms
from arrangement.console.number_form import ReprMixin
from arrangement.errors import InputError
from arrangement.numbers.exact import (
    IntegerVector,
    RationalVector,
    bits,
    dot,
    quotient,
    shown,
    sign_text,
)
from arrangement.numbers.linear.polyhedron import Polyhedron, from_conditions
from arrangement.numbers.linear.rank import rank, triple_product
from arrangement.numbers.symbolic import real_vector, to_sympy

from .planes import Planes

if TYPE_CHECKING:
    import sympy

#: Signs that a short form shows.
_SHOWN = 40


@dataclass(frozen=True, repr=False)
class Face(ReprMixin):
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
    ([('0', '0'), ('1', '0'), ('0', '1')], '1/2')
    """

    signs: tuple[int, ...]
    dimension: int
    witness: RationalVector = field(compare=False)
    planes: Planes = field(hash=False)

    _synonyms: ClassVar[Mapping[str, str]] = synonyms.FACES

    def __repr__(self) -> str:
        text = sign_text(self.signs[:_SHOWN])
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

    @cached_property
    def closure(self) -> Polyhedron:
        """The face with its boundary."""
        sides: dict[int, list[IntegerVector]] = {0: [], 1: [], -1: []}
        for first in self.planes.firsts:
            *normal, offset = self.planes.integer_planes[first]
            side = self.signs[first]
            sides[side].append(tuple((side or 1) * x for x in (*normal, -offset)))
        polyhedron = from_conditions(sides[1] + sides[-1], sides[0], self.planes.dimension)
        assert polyhedron is not None, "a face has a point"
        return polyhedron

    @property
    def sides(self) -> Planes:
        """The planes of the facets of a region, each with the region on its positive side.

        Raises:
            InputError: if the face is of a dimension less than d.
        """
        if self.dimension < self.planes.dimension:
            raise InputError(f"{self!r} is not a region of R^{self.planes.dimension}; give one")
        rows = [
            [self.signs[i] * x for x in self.planes.integer_planes[i]] for i in sorted(self.walls)
        ]
        return Planes(
            [r[:-1] for r in rows], [r[-1] for r in rows], dimension=self.planes.dimension
        )

    @property
    def is_bounded(self) -> bool:
        """Whether the face has an end in every direction."""
        return self.closure.bounded

    @property
    def level(self) -> int:
        """The dimension of the recession cone: of the directions in which the face is unbounded.

        >>> from arrangement import Arrangement
        >>> strips = Arrangement([[1, 0], [1, 0]], [0, 1])
        >>> [strips.region_at([x, 0]).level for x in ("1/2", 2)]
        [1, 2]
        """
        return rank([*self.rays, *self.lines])

    @property
    def vertices(self) -> tuple[RationalVector, ...]:
        """The corners of the closure; none if it contains a line.

        Those of a face of dimension 2 are in order around it, in R^2 counter-clockwise; if it is
        unbounded, from one unbounded edge to the other.
        """
        if self.lines or self.dimension != 2:
            return () if self.lines else self.closure.points
        corners, order = self.closure.homogeneous[0], self.closure.cycle()
        if self.planes.dimension == 2 and triple_product(*(corners[j] for j in order[:3])) < 0:
            order = order[::-1]
        if self.is_bounded:
            first = order.index(0)
            order = order[first:] + order[:first]
        return tuple(self.closure.points[j] for j in order if corners[j][-1])

    @property
    def rays(self) -> tuple[IntegerVector, ...]:
        """The directions of the unbounded edges: primitive, one for each, modulo `lines`."""
        return self.closure.rays

    @property
    def lines(self) -> tuple[IntegerVector, ...]:
        """A basis of the directions of the lines in the face."""
        return self.closure.lines

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
        """Whether it is a simplicial cone, or elsewhere a simplex, modulo `lines`.

        Where all planes have a point in common every face is a cone, and this one is simplicial if
        the normals of its facets are independent. Faces of other arrangements have to be simplices:
        a bounded region of lines is one if it is a triangle, and no unbounded face is one.

        >>> from arrangement import Arrangement
        >>> lines = Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1])
        >>> [lines.region_at(point).is_simplicial for point in (["1/3", "1/3"], [-1, -1])]
        [True, False]
        """
        if self.rays and not self.planes.has_common_point:
            return False
        # A simplex of dimension n has n + 1 vertices; a simplicial cone, its apex and n rays.
        generators = len(self.closure.points) + len(self.rays)
        return generators == self.dimension - len(self.lines) + 1

    def faces(self) -> tuple[Face, ...]:
        """Return all faces of the arrangement in the closure, lowest first, itself last."""
        dimensions = self.closure.faces
        return tuple(map(self._part, sorted(dimensions, key=dimensions.__getitem__)))

    @property
    def f_vector(self) -> tuple[int, ...]:
        """The number of faces of dimension 0, 1, ... of the closure; the last one is itself."""
        dimensions = list(self.closure.faces.values())
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
        return self.closure.volume

    def _check(self, other: Face) -> None:
        if not isinstance(other, Face) or other.planes != self.planes:
            raise InputError(f"{shown(other)} is not a face of these planes: {self.planes!r}")

    @cached_property
    def _walls(self) -> tuple[tuple[int, int], ...]:
        """For each facet its generators, as bits, and the first plane that cuts it out."""
        facets, first = set(self.closure.facets), dict[int, int]()
        for k, plane in zip(self.planes.firsts, self.planes.distinct_planes, strict=True):
            if (mask := self.closure.on((*plane[:-1], -plane[-1]))) in facets:
                first.setdefault(mask, k)
        return tuple(sorted(first.items(), key=lambda wall: wall[1]))

    def _part(self, mask: int) -> Face:
        """Return the face of the closure that some generators span."""
        rows = [self.closure.homogeneous[0][j] for j in bits(mask)]
        *total, scale = map(sum, zip(*rows, strict=True))
        return Face.at(self.planes, [quotient(x, scale) for x in total])
