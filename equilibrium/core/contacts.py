"""The numbers of all contacts of a grasp, exact and in floats, in the plane and in space.

At a homogeneous motion ``(d_0, d)`` the spring of a contact has the force
``preload d_0 - stiffness N . d`` and its point slips by ``T . d``; both are linear.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import chain
from statistics import median
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from arrangement.numbers.exact import RationalVector, over_unit, primitive
from arrangement.numbers.float_filter import Floats
from equilibrium.model.rows import ContactRows
from equilibrium.model.solution import Leaf

from .contact_law import spring_row
from .float_law import FloatLaw, cone_edges

#: Larger numbers are cut off.
_MAX_FLOAT = 1e60
#: Where all numbers but 0 are in this range, nothing underflows or overflows on the way.
_MIN_MODERATE = 1e-30
_MAX_MODERATE = 1e30


def nearest(x: Fraction) -> float:
    """Return the nearest float of moderate size."""
    try:
        return min(max(float(x), -_MAX_FLOAT), _MAX_FLOAT)
    except OverflowError:
        return _MAX_FLOAT if x > 0 else -_MAX_FLOAT


def are_moderate(numbers: Iterable[Fraction]) -> bool:
    """Return whether bounds of rounding errors may be trusted: no number is tiny or huge."""
    return all(not x or _MIN_MODERATE <= abs(nearest(x)) <= _MAX_MODERATE for x in numbers)


class FloatContacts(FloatLaw):
    """The numbers of contacts in R^n, each rounded once.

    Args:
        number: rounds, to floats or to other numbers of Python.

    Attributes:
        tangent: (m, n), the first tangents.
        length: a typical distance of the contacts from the origin.
    """

    def __init__(self, rows: ContactRows, number: Callable[[Any], Any] = nearest) -> None:
        self.rows, m, n = rows, len(rows), rows.n
        self.turns = np.array(rows.turns)
        self._exact = [
            (*c.normal_wrench, *chain(*c.tangential_wrenches), c.friction, c.stiffness, c.preload)
            for c in rows
        ]
        numbers = [[number(x) for x in row] for row in self._exact]
        table = np.array(numbers, dtype=float if number is nearest else object)
        table = table.reshape(m, n * (1 + rows.tangents) + 3)
        tangents = table[:, n:-3].reshape(m, rows.tangents, n)
        super().__init__(table[:, :n].copy(), tangents, *table[:, -3:].T)
        self.tangent = self.tangents[:, 0]
        points = np.array([[nearest(x) for x in point] for point in rows.points])
        self.length = median(np.linalg.norm(points, axis=1).tolist()) if m else 1.0
        if not self.length > 0:
            self.length = 1.0

    @cached_property
    def moderate(self) -> bool:
        """Whether bounds of rounding errors may be trusted; see `are_moderate`."""
        return all(map(are_moderate, self._exact))

    @cached_property
    def springs(self) -> list[RationalVector]:
        """The exact rows ``(preload, -stiffness N)``."""
        return list(map(spring_row, self.rows))

    def arms(self, arm: float, step: float = 1.0) -> Floats:
        """Return a number for each coordinate of a motion, another one for turns."""
        arms: Floats = np.where(self.turns, arm, step)
        return arms


#: Python integers in an array.
Whole: TypeAlias = npt.NDArray[Any]

_MAX_WORD = 2**62


class IntegerContacts:
    """The numbers of the contacts of a grasp in the plane, in integers.

    Attributes:
        spring: (m, 4), the row ``(preload, -stiffness N)`` times `spring_unit`.
        tangent: (m, 3), T times a number above 0.
        edges: (m, 3), see `cone_edges`, times `edge_unit`.
        max_displacement: how far contact points may move for an equilibrium to count, if bounded.
    """

    def __init__(self, rows: ContactRows, max_displacement: Fraction | None = None) -> None:
        self.rows, self.max_displacement = rows, max_displacement
        m = len(rows)
        spring, wrenches = [], []
        for c in rows:
            spring.append(over_unit(spring_row(c)))
            wrenches.append(over_unit((*c.normal_wrench, *c.tangential_wrenches[0])))
        self.spring = whole([row for row, _ in spring], (m, 4))
        self.spring_unit = whole([unit for _, unit in spring], (m,))
        both = whole([row for row, _ in wrenches], (m, 6))
        friction = whole([c.friction.numerator for c in rows], (m,))
        unit = whole([c.friction.denominator for c in rows], (m,))
        self.tangent = both[:, 3:]
        self.edges = cone_edges(both[:, :3] * unit[:, None], both[:, None, 3:], friction)
        self.edge_unit = unit * whole([unit for _, unit in wrenches], (m,))

    def __len__(self) -> int:
        return len(self.rows)

    @cached_property
    def common_unit(self) -> int:
        """A common denominator of all products of a spring force with an edge."""
        return math.lcm(*(self.spring_unit * self.edge_unit).tolist())

    @cached_property
    def shares(self) -> Whole:
        """`common_unit` over the product of the two units of each contact."""
        shares: Whole = self.common_unit // (self.spring_unit * self.edge_unit)
        return shares

    @cached_property
    def bounds(self) -> tuple[Whole, list[Fraction]]:
        """The rows at least 0 at homogeneous motions that count, and the scale of each.

        Four a contact: of the normal with its sign, of its negative, and the same of the tangent.
        """
        if self.max_displacement is None:
            return whole([], (0, 4)), []
        rows = [
            (self.max_displacement, *(-sign * x for x in wrench))
            for c in self.rows
            for wrench in (c.normal_wrench, *c.tangential_wrenches)
            for sign in (1, -1)
        ]
        primitives = [primitive(row) for row in rows]
        # No wrench is zero, so each row has an entry to compare.
        scales = [
            next(Fraction(x) / y for x, y in zip(short, row, strict=True) if y)
            for short, row in zip(primitives, rows, strict=True)
        ]
        return whole(primitives, (len(rows), 4)), scales

    def bound_leaf(self, motion: Sequence[int], used: Mapping[int, Fraction | int]) -> Leaf:
        """Return the leaf of a virtual motion with some rows of `bounds` times numbers above 0."""
        numbers: dict[int, list[Fraction]] = {}
        for k, multiplier in used.items():
            (i, j), sign = divmod(k // 2, 2), 1 - 2 * (k % 2)
            row = numbers.setdefault(i, [Fraction(0), Fraction(0)])
            row[j] += sign * multiplier * self.bounds[1][k]
        return Leaf(tuple(motion), {}, numbers)

    @cached_property
    def floats(self) -> FloatContacts:
        """The same in floating point."""
        return FloatContacts(self.rows)


def whole(values: Sequence[Any], shape: tuple[int, ...]) -> Whole:
    """Return an array of Python integers."""
    return np.array(values, dtype=object).reshape(shape)


def product(left: Whole, right: Whole) -> Whole:
    """Return the exact matrix product; in machine words where they cannot overflow."""
    one, other = (max(map(abs, factor.flat), default=0) for factor in (left, right))
    if left.shape[1] * one * other < _MAX_WORD and max(one, other) < _MAX_WORD:
        return (left.astype(np.int64) @ right.astype(np.int64)).astype(object)
    exact: Whole = left.dot(right)
    return exact
