"""Arrangements of planes: exact, immutable, in input order, in any dimension and rank.

A plane is ``{x : n . x = b}``. Its positive side is ``n . x > b``. The word "plane" is used in
every dimension (a line in R^2, a hyperplane in R^5).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import combinations
from typing import TYPE_CHECKING, Any

from .errors import InputError
from .exact import (
    IntegerVector,
    RationalVector,
    dot,
    primitive,
    rational_vector,
    shown,
    sign,
    to_text,
)
from .linear import rank

if TYPE_CHECKING:
    from .completeness import CompletenessEvidence
    from .enumeration.great_circles import SphereArrangement


@dataclass(frozen=True, slots=True)
class Face:
    """A face of an arrangement: the set of all points with one sign vector.

    Attributes:
        signs: the sign of ``n_i . x - b_i`` for every input plane, in input order.
        dimension: of the face (the whole space minus the rank of its zero planes).
        witness: an exact point of the face.
    """

    signs: tuple[int, ...]
    dimension: int
    witness: RationalVector


class Arrangement:
    """Finitely many planes ``n_i . x = b_i`` in R^d.

    Each plane keeps its own orientation and its place in the input. It is stored as the positive
    multiple with coprime integer entries, so that equal planes compare equal: ``[2, 0, 0]`` and
    ``[1, 0, 0]`` give equal arrangements, ``[-1, 0, 0]`` does not (its sides are exchanged).

    Args:
        normals: m vectors of length d, exact numbers (see `arrangement.rational`).
        offsets: m exact numbers; left out, all planes pass through the origin.
        dimension: d; needed only when there are no planes.

    Raises:
        InputError: a float, a zero normal (named by its index), or lengths that differ.

    >>> three = Arrangement([[1, 0, 0], [0, 1, 0], ["1/2", "1/3", 1]])
    >>> three.f_vector
    (1, 6, 12, 8)
    """

    dimension: int
    _integer_planes: tuple[IntegerVector, ...]

    def __init__(
        self,
        normals: Iterable[Iterable[Any]],
        offsets: Iterable[Any] | None = None,
        *,
        dimension: int | None = None,
    ) -> None:
        rows = [rational_vector(row, f"normals[{i}]") for i, row in enumerate(_listed(normals))]
        if offsets is None:
            constants: RationalVector = (Fraction(0),) * len(rows)
        else:
            constants = rational_vector(offsets, "offsets")
        if len(constants) != len(rows):
            raise InputError(
                f"there are {len(rows)} normals and {len(constants)} offsets; give one offset "
                "for each normal, or none at all"
            )
        d = _common_length(rows, dimension)
        for i, row in enumerate(rows):
            if not any(row):
                raise InputError(
                    f"normals[{i}] is the zero vector, which defines no plane; remove plane {i}"
                )
        planes = tuple(primitive((*row, b)) for row, b in zip(rows, constants, strict=True))
        self.__dict__.update(dimension=d, _integer_planes=planes)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(
            f"an Arrangement is immutable, so {name} cannot be set; build a new one"
        )

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"an Arrangement is immutable, so {name} cannot be deleted")

    def __getstate__(self) -> dict[str, Any]:
        """Copies and pickles carry the planes, not what was computed from them."""
        return {"dimension": self.dimension, "_integer_planes": self._integer_planes}

    @property
    def integer_planes(self) -> tuple[IntegerVector, ...]:
        """The planes as coprime integers ``(n_1, ..., n_d, b)``, in input order."""
        return self._integer_planes

    @property
    def normals(self) -> tuple[RationalVector, ...]:
        """The normals in input order, in the stored (coprime integer) scaling."""
        return tuple(tuple(Fraction(x) for x in plane[:-1]) for plane in self._integer_planes)

    @property
    def offsets(self) -> RationalVector:
        """The offsets in input order, in the stored (coprime integer) scaling."""
        return tuple(Fraction(plane[-1]) for plane in self._integer_planes)

    def __len__(self) -> int:
        return len(self._integer_planes)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Arrangement):
            return NotImplemented
        return (self.dimension, self._integer_planes) == (other.dimension, other._integer_planes)

    def __hash__(self) -> int:
        return hash((self.dimension, self._integer_planes))

    def __repr__(self) -> str:
        kind = "central" if self.is_central else "affine"
        return (
            f"<Arrangement: {len(self)} planes ({len(self.distinct)} distinct) in "
            f"R^{self.dimension}, rank {self.rank}, {kind}>"
        )

    def _repr_svg_(self) -> str | None:
        """Return what a notebook shows: the great circles, where there are any."""
        from .draw.notebook import arrangement_svg

        return arrangement_svg(self)

    def _repr_html_(self) -> str | None:
        """Return what a notebook shows where there is no picture: a table of counts."""
        from .draw.notebook import arrangement_html

        return arrangement_html(self)

    @cached_property
    def class_of(self) -> tuple[int, ...]:
        """For each plane, the index of its class of coincident planes."""
        index: dict[IntegerVector, int] = {}
        return tuple(index.setdefault(_unoriented(p), len(index)) for p in self._integer_planes)

    @cached_property
    def distinct(self) -> tuple[tuple[int, ...], ...]:
        """The classes of coincident planes, as plane indices, in order of first appearance."""
        classes: dict[int, list[int]] = {}
        for plane, label in enumerate(self.class_of):
            classes.setdefault(label, []).append(plane)
        return tuple(tuple(members) for members in classes.values())

    @cached_property
    def orientation(self) -> tuple[int, ...]:
        """For each plane, +1 if it is oriented like the first plane of its class, else -1."""
        first = [self._integer_planes[members[0]] for members in self.distinct]
        return tuple(
            1 if plane == first[label] else -1
            for plane, label in zip(self._integer_planes, self.class_of, strict=True)
        )

    @cached_property
    def rank(self) -> int:
        """The dimension of the span of the normals."""
        return rank([plane[:-1] for plane in self._integer_planes])

    @cached_property
    def is_central(self) -> bool:
        """Whether all offsets are zero, so that every plane passes through the origin."""
        return all(plane[-1] == 0 for plane in self._integer_planes)

    @cached_property
    def is_simple(self) -> bool:
        """Whether the distinct planes are in general position.

        Central: any ``min(d, m)`` of the m distinct normals are independent. Affine: any
        ``k <= d`` planes meet in dimension ``d - k``, and no ``d + 1`` of them meet at all.
        Checked by ranks of all subsets of that size: polynomial in m for fixed d.
        """
        planes = [self._integer_planes[members[0]] for members in self.distinct]
        size = min(self.dimension, len(planes))
        if any(rank([p[:-1] for p in chosen]) < size for chosen in combinations(planes, size)):
            return False
        if self.is_central:
            return True
        beyond = combinations(planes, self.dimension + 1)
        return all(rank(chosen) == self.dimension + 1 for chosen in beyond)

    def signs_at(self, point: Iterable[Any]) -> tuple[int, ...]:
        """Return the sign of ``n_i . x - b_i`` at a point x of R^d, for every input plane."""
        x = rational_vector(point, "point")
        if len(x) != self.dimension:
            raise InputError(f"point has {len(x)} coordinates; this space has {self.dimension}")
        integers = primitive((*x, Fraction(-1)))
        return tuple(sign(dot(plane, integers)) for plane in self._integer_planes)

    def iter_faces(self, dimension: int | None = None) -> Iterator[Face]:
        """Yield every face (of one dimension, if given) with an exact witness.

        Order: by dimension, lowest first. Complexity: see `arrangement.enumeration.any_dimension`.
        """
        return iter(self.faces(dimension))

    def faces(self, dimension: int | None = None) -> tuple[Face, ...]:
        """Return every face, or those of one dimension, lowest dimension first."""
        if dimension is None:
            return tuple(face for level in self._faces for face in level)
        if type(dimension) is not int or not 0 <= dimension <= self.dimension:
            raise InputError(
                f"dimension is {shown(dimension)}; faces have dimension 0 to {self.dimension}"
            )
        return self._faces[dimension]

    @cached_property
    def _faces(self) -> tuple[tuple[Face, ...], ...]:
        from .enumeration.any_dimension import enumerate_faces

        return enumerate_faces(self)

    def regions(self) -> tuple[Face, ...]:
        """Return the faces of full dimension: the cells that no plane meets."""
        return self.faces(self.dimension)

    @cached_property
    def f_vector(self) -> tuple[int, ...]:
        """The number of faces of dimension 0, 1, ..., d, by enumeration."""
        return tuple(len(level) for level in self._faces)

    def sphere(self) -> SphereArrangement:
        """Return the great circles of a central arrangement in R^3, with their full incidence."""
        from .enumeration.great_circles import sphere_arrangement

        return sphere_arrangement(self)

    def certify_complete(self) -> CompletenessEvidence:
        """Compare `faces` with Zaslavsky's theorem, face by face and in number."""
        from .completeness import certify_complete

        return certify_complete(self)

    def to_dict(self) -> dict[str, Any]:
        """Return the file form (see `arrangement.read_arrangement`)."""
        document: dict[str, Any] = {
            "schema_version": 1,
            "planes": [[to_text(x) for x in plane[:-1]] for plane in self._integer_planes],
        }
        if not self.is_central:
            document["offsets"] = [to_text(plane[-1]) for plane in self._integer_planes]
        if not self._integer_planes:
            document["dimension"] = self.dimension
        return document


def _listed(normals: Any) -> list[Any]:
    """Return the rows of the input as a list, refusing what is no sequence."""
    if isinstance(normals, (str, bytes)) or not isinstance(normals, Iterable):
        raise InputError("normals must be a sequence of vectors, one for each plane")
    return list(normals)


def _common_length(rows: list[RationalVector], dimension: int | None) -> int:
    """Return d, after checking that every normal has d entries."""
    if dimension is None:
        if not rows:
            raise InputError("no planes are given, so d is unknown; pass dimension=d")
        dimension = len(rows[0])
    if type(dimension) is not int or dimension < 1:
        raise InputError(f"the dimension is {shown(dimension)}; give an integer, at least 1")
    for i, row in enumerate(rows):
        if len(row) != dimension:
            raise InputError(
                f"normals[{i}] has {len(row)} entries and the dimension is {dimension}; "
                "all normals need one entry for each coordinate"
            )
    return dimension


def _unoriented(plane: IntegerVector) -> IntegerVector:
    """Return the plane or its negative, whichever has a positive leading entry."""
    leading = next(x for x in plane if x)
    return plane if leading > 0 else tuple(-x for x in plane)
