"""Hyperplane arrangements: exact, immutable, in input order, in any dimension and rank.

A hyperplane is ``{x : n . x = b}``. Its positive side is ``n . x > b``. Names say "plane" in every
dimension (a line in R^2, a hyperplane in R^5).
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import chain, combinations
from typing import TYPE_CHECKING, Any, NamedTuple, Self, TypeAlias, overload

from arrangement.errors import InputError, missing_item
from arrangement.hints import HintsMixin
from arrangement.numbers import budget
from arrangement.numbers.arguments import entries
from arrangement.numbers.exact import (
    IntegerVector,
    RationalVector,
    all_reduced,
    bit_size,
    dot,
    fraction,
    one_way,
    plain_rows,
    primitive,
    rational_vector,
    shown,
    sign,
    without_denominators,
)
from arrangement.numbers.linear.rank import rank
from arrangement.numbers.real import field_of, written
from arrangement.numbers.symbolic import (
    entry,
    equations_of,
    exact_matrix,
    in_one_field,
    planes_of,
    real_vector,
)

from .equation_text import equation_text, planes_of_text

if TYPE_CHECKING:
    import sympy
    from sympy.polys.matrices import DomainMatrix

    from arrangement.numbers.fields import NumberField


Names: TypeAlias = Iterable[str] | Mapping[int, str]
#: Characters of the name of a plane.
_LONGEST_NAME = 40
#: Added where there is a text.
_EQUATIONS = ", or Arrangement.from_equations(['x = 0', 'y = 0'])"
_VECTORS = f"give vectors of exact numbers, [[1, 0], [0, 1]]{_EQUATIONS}"
#: Bits of a number that takes longer than others.
_LONG_BITS = 1000


class Hyperplane(NamedTuple):
    """A hyperplane ``normal . x = offset``, as `Planes` gives it when it is indexed or iterated."""

    normal: RationalVector
    offset: Fraction

    def __str__(self) -> str:
        return equation_text(self.normal, self.offset)

    def __repr__(self) -> str:
        return f"<Hyperplane: {self}>"


class Planes(HintsMixin):
    """Finitely many hyperplanes ``n_i . x = b_i`` in R^d, as a value without algorithms.

    `arrangement.Arrangement` adds faces to it, and describes how planes are stored.

    Args:
        normals: m vectors of length d, exact numbers (integers, fractions, texts such as "7/3");
            or a SymPy matrix or an array of them, m x d.
        offsets: m exact numbers; if omitted, all planes pass through the origin.
        dimension: d; needed only when there are no planes.
        axes: names of the coordinates where these mean something, as motions x, y, r do. A label:
            no comparison looks at it, but pictures keep such coordinates.
        names: of the planes, in their order, "" for none; or by number, from 1 on. Labels, too:
            pictures and files have them.

    Raises:
        InputError: a float, a zero normal (named by its number, from 1), or lengths that differ.

    >>> Planes([[2, 0, 0], [0, 1, 0], ["1/2", "1/3", 1]]).integer_planes
    ((1, 0, 0, 0), (0, 1, 0, 0), (3, 2, 6, 0))
    """

    dimension: int
    axes: tuple[str, ...]
    names: tuple[str, ...]
    _integer_planes: tuple[IntegerVector, ...]

    def __init__(
        self,
        normals: Iterable[Iterable[Any]],
        offsets: Iterable[Any] | None = None,
        *,
        dimension: int | None = None,
        axes: Iterable[str] = (),
        names: Names = (),
    ) -> None:
        listed = _rows_as_list(normals)
        entries = sum(len(row) for row in listed if isinstance(row, (list, tuple)))
        budget.check_cost(f"{entries:,} numbers", "give fewer planes", bytes=60 * entries)
        plain = plain_rows(listed)
        rows: list[Any] = plain or [
            rational_vector(row, f"normal {i + 1}", entry) for i, row in enumerate(listed)
        ]
        if offsets is None:
            constants: Any = (0,) * len(rows)
        else:
            (constants,) = plain_rows([offsets]) or (rational_vector(offsets, "offsets", entry),)
        whole = plain is not None and set(map(type, constants)) <= {int}
        if not whole:
            *rows, constants = in_one_field([*rows, constants])
        if len(constants) != len(rows):
            raise InputError(
                f"there are {len(rows)} normals and {len(constants)} offsets; give one offset "
                "for each normal, or none at all"
            )
        d = _common_length(rows, dimension)
        if not all(map(any, rows)):
            i = next(i for i, row in enumerate(rows) if not any(row))
            raise InputError(
                f"normal {i + 1} is the zero vector, which defines no plane; remove this plane"
            )
        if not whole:
            _check_digits(chain.from_iterable(rows))
        joined = [(*row, b) for row, b in zip(rows, constants, strict=True)]
        planes = tuple(all_reduced(joined if whole else list(map(without_denominators, joined))))
        self.__dict__.update(
            dimension=d,
            axes=tuple(axes),
            names=checked_names(names, len(planes)),
            _integer_planes=planes,
        )

    @classmethod
    def from_equations(
        cls, equations: Iterable[Any] | str, symbols: Iterable[sympy.Symbol] | None = None
    ) -> Self:
        """Return the planes of linear equations in SymPy symbols, or as text.

        Args:
            equations: ``Eq(left, right)``, or expressions that are zero on the plane; or all of
                them texts such as ``"x - 2*y = 1"``, or ``"ell: x = 1"`` with a name, read as in
                files and never evaluated; or one text of them, with commas between. The positive
                side is where the left side is the larger one, or the expression positive.
            symbols: the coordinates in their order. If omitted, all symbols of the equations,
                sorted by name; then a coordinate that no equation has is missing. Texts in x, y, z
                have x and y at least.

        Raises:
            InputError: a term that is not a rational number times one of the symbols, or not a
                rational constant. The message names it.

        >>> from sympy import Eq
        >>> from sympy.abc import x, y, z
        >>> Planes.from_equations([Eq(x, y), 2*x + 3*z - 1], (x, y, z)).integer_planes
        ((1, -1, 0, 0), (2, 0, 3, 1))
        >>> Planes.from_equations(["x = y", "2*x + 3*z - 1"]).integer_planes
        ((1, -1, 0, 0), (2, 0, 3, 1))
        """
        if isinstance(equations, str):
            equations = re.split("[,;]", equations)
        sides = entries(equations, "equations", "equations")
        if sides and all(isinstance(equation, str) for equation in sides):
            kind = "symbols, after all equations in one text or list"
            listed = () if symbols is None else entries(symbols, "symbols", kind)
            axes = None if symbols is None else list(map(str, listed))
            rows, constants, axes, names = planes_of_text(sides, axes)
            return cls(rows, constants, dimension=len(axes), names=names)
        normals, offsets, dimension = planes_of(sides, symbols)
        return cls(normals, offsets, dimension=dimension or None)

    def equations(self, symbols: Iterable[sympy.Symbol] | None = None) -> tuple[sympy.Eq, ...]:
        """Return an equation ``n . x = b`` for each plane, in the stored scaling.

        Args:
            symbols: one for each coordinate; if omitted, x, y, z, or x1, x2, ... beyond R^3.

        >>> Planes([[2, -1], [0, 3]], [1, 2]).equations()
        (Eq(2*x - y, 1), Eq(3*y, 2))
        """
        return equations_of(self._integer_planes, self.dimension, symbols)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"planes are immutable, so {name} cannot be set; build new ones")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"planes are immutable, so {name} cannot be deleted")

    def __getstate__(self) -> dict[str, Any]:
        """Copies and pickles carry the planes, not what was computed from them."""
        stored = ("dimension", "axes", "names", "_integer_planes")
        return {name: self.__dict__[name] for name in stored}

    def named(self, names: Names) -> Self:
        """Return the same planes with other names, as of `Planes`.

        >>> Planes([[1, 0], [0, 1]]).named({2: "m"}).names
        ('', 'm')
        """
        made = self.__copy__()
        made.__dict__["names"] = checked_names(names, len(self))
        return made

    def __copy__(self) -> Self:
        made = object.__new__(type(self))
        made.__dict__.update(self.__getstate__())
        return made

    @property
    def integer_planes(self) -> tuple[IntegerVector, ...]:
        """The planes as coprime integers ``(n_1, ..., n_d, b)``, in input order."""
        return self._integer_planes

    @cached_property
    def matrix(self) -> DomainMatrix:
        """The planes as a SymPy matrix over ZZ, or over their field: rows ``n_1 ... n_d b``."""
        return exact_matrix(self._integer_planes, self.dimension + 1)

    @property
    def normals(self) -> tuple[RationalVector, ...]:
        """The normals in input order, in the stored (coprime integer) scaling."""
        return tuple(tuple(map(fraction, plane[:-1])) for plane in self._integer_planes)

    @property
    def offsets(self) -> RationalVector:
        """The offsets in input order, in the stored (coprime integer) scaling."""
        return tuple(fraction(plane[-1]) for plane in self._integer_planes)

    def __len__(self) -> int:
        return len(self._integer_planes)

    def __iter__(self) -> Iterator[Hyperplane]:
        return map(self.__getitem__, range(len(self)))

    @overload
    def __getitem__(self, index: int) -> Hyperplane: ...
    @overload
    def __getitem__(self, index: slice) -> Self: ...
    def __getitem__(self, index: int | slice) -> Hyperplane | Self:
        """Return a hyperplane by its number from 0, in the stored scaling; of a slice, planes.

        >>> lines = Planes([[2, 0], [0, 1], [1, -1]], [2, 0, "1/2"])
        >>> [str(line) for line in lines], lines[1:].integer_planes
        (['x = 1', 'y = 0', '2*x - 2*y = 1'], ((0, 1, 0), (2, -2, 1)))
        """
        if isinstance(index, slice):
            chosen = self._integer_planes[index]
            return type(self)(
                [plane[:-1] for plane in chosen],
                [plane[-1] for plane in chosen],
                dimension=self.dimension,
                axes=self.axes,
                names=self.names[index],
            )
        try:
            plane = self._integer_planes[index]
        except (IndexError, TypeError):
            raise missing_item("plane", index, len(self)) from None
        *normal, offset = map(fraction, plane)
        return Hyperplane(tuple(normal), offset)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Planes):
            return NotImplemented
        return (self.dimension, self._integer_planes) == (other.dimension, other._integer_planes)

    def __hash__(self) -> int:
        return hash((self.dimension, self._integer_planes))

    def __repr__(self) -> str:
        kind = "central" if self.is_central else "affine"
        planes = f"{len(self)} plane{'s' * (len(self) != 1)} ({len(self.distinct)} distinct)"
        where = f"R^{self.dimension}, rank {self.rank}, {kind}"
        return f"<{type(self).__name__}: {planes} in {where}>"

    @cached_property
    def field(self) -> NumberField | None:
        """The field of the entries; None if all are rational, in the stored scaling."""
        field: NumberField | None = field_of(chain.from_iterable(self._integer_planes))
        return field

    @cached_property
    def class_of(self) -> tuple[int, ...]:
        """For each plane, the index of its class of coincident planes."""
        index: dict[IntegerVector, int] = {}
        return tuple(index.setdefault(one_way(p), len(index)) for p in self._integer_planes)

    @cached_property
    def distinct(self) -> tuple[tuple[int, ...], ...]:
        """The classes of coincident planes, as plane indices, in order of first appearance."""
        if self.class_of[-1:] == (len(self) - 1,):  # all are different
            return tuple(zip(range(len(self)), strict=True))
        classes: dict[int, list[int]] = {}
        for plane, label in enumerate(self.class_of):
            classes.setdefault(label, []).append(plane)
        return tuple(tuple(members) for members in classes.values())

    @cached_property
    def firsts(self) -> tuple[int, ...]:
        """The first plane of each class of coincident planes, by number."""
        return tuple(members[0] for members in self.distinct)

    @cached_property
    def distinct_planes(self) -> tuple[IntegerVector, ...]:
        """The first plane of each class of coincident planes, as in `integer_planes`."""
        return tuple(self._integer_planes[first] for first in self.firsts)

    @cached_property
    def orientation(self) -> tuple[int, ...]:
        """For each plane, +1 if it is oriented like the first plane of its class, else -1."""
        first = self.distinct_planes
        return tuple(
            1 if plane == first[label] else -1
            for plane, label in zip(self._integer_planes, self.class_of, strict=True)
        )

    def over_planes(self, sides: Sequence[int]) -> tuple[int, ...]:
        """Return a sign vector, from the sides of the first plane of each class."""
        turned = zip(self.orientation, self.class_of, strict=True)
        return tuple(flip * sides[label] for flip, label in turned)

    @cached_property
    def rank(self) -> int:
        """The dimension of the span of the normals."""
        return rank([self._integer_planes[members[0]][:-1] for members in self.distinct])

    @property
    def is_essential(self) -> bool:
        """Whether the normals span R^d: the rank is the dimension."""
        return self.rank == self.dimension

    @cached_property
    def is_central(self) -> bool:
        """Whether all offsets are zero, so that every plane passes through the origin."""
        return all(plane[-1] == 0 for plane in self._integer_planes)

    @cached_property
    def has_common_point(self) -> bool:
        """Whether some point, the origin or another one, lies on every plane.

        >>> Planes([[1, 0], [0, 1], [1, 1]], [1, 1, 2]).has_common_point
        True
        """
        return rank(self._integer_planes) == self.rank

    def has_same_planes(self, other: Planes) -> bool:
        """Return whether both are the same set of planes, whatever their order, sides and repeats.

        >>> Planes([[1, 0], [0, 1]]).has_same_planes(Planes([[0, -2], [1, 0], [0, 1]]))
        True
        """
        one, two = ({one_way(p) for p in planes._integer_planes} for planes in (self, other))
        return self.dimension == other.dimension and one == two

    @cached_property
    def is_simple(self) -> bool:
        """Whether the distinct planes are in general position.

        Central: any ``min(d, m)`` of the m distinct normals are independent. Affine: any
        ``k <= d`` planes meet in dimension ``d - k``, and no ``d + 1`` of them meet at all. So more
        than d planes through a point off the origin are never simple: they are affine, and other
        planes near them do not meet. Move the point to the origin to ask as for central planes.
        Checked by ranks of all subsets of that size: polynomial in m for fixed d.

        >>> through_a_point = [[1, 0], [0, 1], [1, 1]]
        >>> Planes(through_a_point).is_simple, Planes(through_a_point, [1, 1, 2]).is_simple
        (True, False)
        """
        planes = self.distinct_planes
        size = min(self.dimension, len(planes))
        if any(rank([p[:-1] for p in chosen]) < size for chosen in combinations(planes, size)):
            return False
        if self.is_central:
            return True
        beyond = combinations(planes, self.dimension + 1)
        return all(rank(chosen) == self.dimension + 1 for chosen in beyond)

    def signs_at(self, point: Iterable[Any]) -> tuple[int, ...]:
        """Return the sign of ``n_i . x - b_i`` at a point x of R^d, for every input plane."""
        x = real_vector(point, "point", self.field)
        if len(x) != self.dimension:
            raise InputError(f"point has {len(x)} coordinates; this space has {self.dimension}")
        integers = primitive((*x, Fraction(-1)))
        return tuple(sign(dot(plane, integers)) for plane in self._integer_planes)

    def to_dict(self) -> dict[str, Any]:
        """Return the file form (see `arrangement.read_arrangement`)."""
        document: dict[str, Any] = {"schema_version": 1}
        if self.field is not None:
            document["field"] = self.field.to_dict()
        document["planes"] = [[written(x) for x in plane[:-1]] for plane in self._integer_planes]
        if not self.is_central:
            document["offsets"] = [written(plane[-1]) for plane in self._integer_planes]
        if not self._integer_planes:
            document["dimension"] = self.dimension
        if self.names:
            document["names"] = list(self.names)
        return document


def checked_names(names: Names, count: int, what: str = "plane") -> tuple[str, ...]:
    """Return a name for each of some planes, "" for none; nothing if no plane has one."""
    if isinstance(names, tuple) and not names:  # as most planes have none
        return ()
    listed = () if isinstance(names, Mapping) else entries(names, "names", "names")
    texts = dict(names) if isinstance(names, Mapping) else dict(enumerate(listed, 1))
    if not isinstance(names, Mapping) and len(texts) not in (0, count):
        raise InputError(f"there are {len(texts)} names and {count} {what}s; give one for each")
    for number, text in texts.items():
        if type(number) is not int or not 1 <= number <= count:
            raise InputError(f"{what} {shown(number)} has a name; there are {what}s 1 to {count}")
        plain = isinstance(text, str) and text.isprintable() and not text.isdecimal()
        if not plain or len(text) > _LONGEST_NAME:
            raise InputError(
                f"the name of {what} {number} is {shown(text)}; give a text in one line of at most "
                f"{_LONGEST_NAME} characters that is not a number"
            )
    return tuple(texts.get(k + 1, "") for k in range(count)) if any(texts.values()) else ()


def _check_digits(numbers: Iterable[Any]) -> None:
    """Refuse numbers so long that to divide by common divisors takes too many steps."""
    bits, steps = [], 0.0
    for x in numbers:
        is_rational = isinstance(x, (int, Fraction))
        n = x.numerator.bit_length() if is_rational else bit_size(x)
        if n > _LONG_BITS:
            bits.append(n)
            steps += n * n / 10_000 if is_rational else n**1.5 / 500
    what = f"planes of {len(bits)} numbers of up to {max(bits, default=0)} bits"
    budget.check_cost(what, "round them", steps=steps)


def _rows_as_list(normals: Any) -> list[Any]:
    """Return the rows of the input as a list, refusing what is not a sequence."""
    if hasattr(normals, "tolist"):  # SymPy's matrices and arrays run through their entries
        normals = normals.tolist()
    if isinstance(normals, (str, bytes)) or not isinstance(normals, Iterable):
        files = ", or read_arrangement(path)" if isinstance(normals, str) else ""
        raise InputError(f"normals is {shown(normals)}; {_VECTORS}{files}")
    rows = list(normals)
    if rows and (isinstance(rows[0], str) or not isinstance(rows[0], Iterable)):
        raise InputError(f"normal 1 is {shown(rows[0])}; {_VECTORS}")
    return rows


def _common_length(rows: list[RationalVector], dimension: int | None) -> int:
    """Return d, after checking that every normal has d entries."""
    if dimension is None:
        if not rows:
            remedy = budget.by_caller("pass dimension=d", 'add the key "dimension"')
            raise InputError(f"no planes are given, so the dimension d is unknown; {remedy}")
        dimension = len(rows[0])
    if type(dimension) is not int or dimension < 0:
        raise InputError(f"the dimension is {shown(dimension)}; give an integer, at least 0")
    if rows and not dimension:
        raise InputError("a plane needs a dimension of at least 1, and the normals have no entries")
    for i, row in enumerate(rows):
        if len(row) != dimension:
            raise InputError(
                f"normal {i + 1} has {len(row)} entries and the dimension is {dimension}; "
                "all normals need one entry for each coordinate"
            )
    return dimension
