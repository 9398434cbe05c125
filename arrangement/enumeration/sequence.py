"""All faces of some planes as one sequence: arrays inside, a tuple of `Face` to the user.

An engine hands over one `Level` for each dimension. Signs and witnesses are made for the faces
that are asked for, when they are asked for.
"""

from __future__ import annotations

from abc import ABCMeta
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, ClassVar, TypeAlias, overload

import numpy as np
from numpy.typing import NDArray

from arrangement import synonyms
from arrangement.console.number_form import ReprMixin
from arrangement.errors import InputError, missing_item
from arrangement.hints import Hints
from arrangement.numbers import budget
from arrangement.numbers.coefficients import Coefficients, Integers
from arrangement.numbers.exact import RationalVector, fraction, quotient, shown
from arrangement.planes.faces import Face
from arrangement.planes.planes import Planes

Signs: TypeAlias = NDArray[np.int8]
Rows: TypeAlias = "slice | NDArray[np.intp]"

#: Faces made at once when a sequence is walked.
_BLOCK = 4096


@dataclass(frozen=True, slots=True)
class Level:
    """The faces of one dimension, as an engine knows them.

    Attributes:
        count: their number.
        signs: from chosen rows to their signs, one column for each input plane.
        points: from chosen rows to exact points, d + 1 integers ``(X, W)`` with W > 0 for X / W.
        scalable: of central planes, whether any positive multiple of a point will do as well.
    """

    count: int
    signs: Callable[[Rows], Signs]
    points: Callable[[Rows], Integers]
    scalable: bool = True


def no_faces(planes: int, dimension: int) -> Level:
    """Return an empty level of planes in R^dimension."""
    return Level(
        0,
        lambda rows: np.empty((0, planes), np.int8),
        lambda rows: np.empty((0, dimension + 1), np.int64),
    )


class _SequenceHints(Hints, ABCMeta):
    """The class of a sequence that answers names which it does not have."""


class FaceSequence(ReprMixin, Sequence[Face], metaclass=_SequenceHints):
    """The faces of an arrangement, or those of one dimension, in a fixed order.

    It looks like a tuple of `Face`: length, indices, slices (which are tuples), iteration. The
    arrays behind it are `signs`, `dimensions` and `points`.

    Order: by dimension, lowest first. Within a dimension it is the order of the engine: the same
    for the same planes, without a meaning.

    Attributes:
        engine: the name of the engine that found them.
        levels: as that engine handed them over.
    """

    repr_fields = ("f_vector", "engine")
    _synonyms: ClassVar[Mapping[str, str]] = synonyms.SEQUENCES

    def __init__(
        self, planes: Planes, levels: Sequence[Level], engine: str, lowest: int = 0
    ) -> None:
        self.engine = engine
        self._planes = planes
        self.levels = tuple(levels)
        self._lowest = lowest
        self._ends = np.cumsum([level.count for level in levels], dtype=np.intp)

    @property
    def f_vector(self) -> tuple[int, ...]:
        """The number of faces of each dimension, lowest first."""
        return tuple(level.count for level in self.levels)

    @cached_property
    def dimensions(self) -> Signs:
        """(count); the dimension of each face."""
        dimensions = np.arange(self._lowest, self._lowest + len(self.levels), dtype=np.int8)
        return _freeze(np.repeat(dimensions, self.f_vector))

    @cached_property
    def signs(self) -> Signs:
        """(count, m); the sign of every face at every input plane. Count times m bytes."""
        empty = np.empty((0, len(self._planes)), np.int8)
        parts = [level.signs(slice(None)) for level in self.levels if level.count]
        return _freeze(np.concatenate([empty, *parts]))

    @cached_property
    def points(self) -> Integers:
        """(count, d + 1); an exact point in every face: integers ``(X, W)``, W > 0, for X / W."""
        empty = np.empty((0, self._planes.dimension + 1), np.int64)
        parts = [level.points(slice(None)) for level in self.levels if level.count]
        return _freeze(np.concatenate([empty, *parts]))

    def of_dimension(self, dimension: int) -> FaceSequence:
        """Return the faces of one dimension."""
        place = dimension - self._lowest if type(dimension) is int else -1
        if not 0 <= place < len(self.levels):
            highest = self._lowest + len(self.levels) - 1
            raise InputError(
                f"dimension is {shown(dimension)}; faces have dimension {self._lowest} to {highest}"
            )
        return FaceSequence(self._planes, [self.levels[place]], self.engine, dimension)

    def where(self, chosen: Sequence[bool] | NDArray[np.bool_]) -> FaceSequence:
        """Return the faces that an array of truth values chooses, in their order.

        Args:
            chosen: (count), as in ``regions.where(regions.signs[:, 0] > 0)``.
        """
        truth = np.asarray(chosen)
        if truth.dtype != bool or truth.shape != (len(self),):
            raise InputError(
                f"the choice is {shown(chosen)}; give one truth value for each of {len(self)} faces"
            )
        parts = np.split(truth, self._ends[:-1])
        levels = [
            _part(level, np.flatnonzero(part))
            for level, part in zip(self.levels, parts, strict=True)
        ]
        return FaceSequence(self._planes, levels, self.engine, self._lowest)

    def __len__(self) -> int:
        return int(self._ends[-1])

    @overload
    def __getitem__(self, index: int) -> Face: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[Face, ...]: ...
    def __getitem__(self, index: int | slice) -> Face | tuple[Face, ...]:
        try:
            chosen = range(len(self))[index]
        except (IndexError, TypeError):
            raise missing_item("face", index, len(self)) from None
        if isinstance(chosen, int):
            return next(self._faces_at(np.array([chosen])))
        signs = len(chosen) * len(self._planes)
        budget.check_cost(
            f"a tuple of faces with {signs:,} signs", "go through them", bytes=24 * signs
        )
        return tuple(self._faces_at(np.array(chosen, np.intp)))

    def __iter__(self) -> Iterator[Face]:
        for start in range(0, len(self), _BLOCK):
            yield from self._faces_at(np.arange(start, min(start + _BLOCK, len(self))))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, (FaceSequence, tuple)):
            return NotImplemented
        return self is other or (len(self) == len(other) and tuple(self) == tuple(other))

    def __hash__(self) -> int:
        return hash((self._planes, self.engine, self._lowest, len(self.levels)))

    def __repr__(self) -> str:
        return f"<FaceSequence: {len(self)} faces, f-vector {self.f_vector}, by {self.engine}>"

    def _faces_at(self, places: NDArray[np.intp]) -> Iterator[Face]:
        """Yield the faces at some places, a run of one dimension at a time."""
        levels = np.searchsorted(self._ends, places, side="right")
        cuts = np.flatnonzero(np.diff(levels)) + 1
        for run, of in zip(np.split(places, cuts), np.split(levels, cuts), strict=True):
            if not len(run):
                continue
            level, dimension = self.levels[of[0]], self._lowest + int(of[0])
            rows = run - (self._ends[of[0]] - level.count)
            points = level.points(rows)
            if self._planes.is_central and level.scalable:
                directions = primitive_rows(points[:, :-1])
                points = np.column_stack([directions, np.ones_like(points[:, -1])])
            witnesses = rational_points(points)
            for signs, witness in zip(level.signs(rows).tolist(), witnesses, strict=True):
                yield Face(tuple(signs), dimension, witness, self._planes)


def _part(level: Level, chosen: NDArray[np.intp]) -> Level:
    return Level(
        len(chosen),
        lambda rows: level.signs(chosen[rows]),
        lambda rows: level.points(chosen[rows]),
        level.scalable,
    )


def primitive_rows(rows: Integers) -> Integers:
    """Return vectors along the last axis, each divided by its greatest common divisor."""
    if rows.dtype == object and not all(isinstance(x, int) for x in rows.flat):
        flat = rows.reshape(-1, rows.shape[-1]).tolist()
        numbers = Coefficients(flat)
        lines, _, sides = numbers.unoriented(numbers.array(flat, rows.shape[-1]))
        return numbers.numbers(lines * sides[:, None, None]).reshape(rows.shape)
    divisors = np.abs(np.gcd.reduce(rows, axis=-1, keepdims=True))  # of one object: with its sign
    whole: Integers = rows // np.maximum(divisors, 1)
    return whole


def rational_points(points: Integers) -> Iterator[RationalVector]:
    """Yield the points X / W of rows ``(X, W)``, equal numbers as one object."""
    known = _KnownFractions()
    for *point, scale in points.tolist():
        yield tuple([known[x, scale] for x in point])


class _KnownFractions(dict[tuple[int, int], Fraction]):
    """Quotients of integers, each made once: short ones come again and again."""

    def __missing__(self, pair: tuple[int, int]) -> Fraction:
        x, scale = pair
        return self.setdefault(pair, fraction(x) if scale == 1 else quotient(x, scale))


def _freeze(array: NDArray[Any]) -> NDArray[Any]:
    array.flags.writeable = False
    return array
