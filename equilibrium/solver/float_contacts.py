"""The data of contacts in floating point, with bounds of the rounding.

Only numbers of moderate size are taken, so that nothing underflows or overflows on the way.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cached_property
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from arrangement.float_filter import Floats, error_bound
from equilibrium.model.grasp import Grasp

Integers: TypeAlias = npt.NDArray[np.int64]

#: Other numbers than 0 outside this range are left to exact arithmetic, so that nothing underflows.
_SMALL, _LARGE = 1e-30, 1e30


class OutOfRange(Exception):
    """A number that floating point should not see."""


def floats(rows: Iterable[Sequence[Fraction]]) -> Floats:
    """Return the nearest floats."""
    try:
        numbers = np.array([[float(x) for x in row] for row in rows])
    except OverflowError:
        raise OutOfRange from None
    size = np.abs(numbers)
    outside = (size > _LARGE) | (size < _SMALL)
    if np.any(outside) and any(
        x != 0
        for row, out in zip(rows, outside, strict=True)
        for x, o in zip(row, out, strict=True)
        if o
    ):
        raise OutOfRange
    return numbers


class RoundedContacts:
    """The data of the contacts, rounded to the nearest floats (one rounding each)."""

    def __init__(self, grasp: Grasp) -> None:
        m = len(grasp)
        along = floats([(*c.normal_wrench, *c.tangential_wrench) for c in grasp]).reshape(m, 6)
        numbers = floats([(c.stiffness, c.preload, c.friction) for c in grasp]).reshape(m, 3)
        stiffness, self.preload, self.friction = numbers.T
        self.normal, self.tangent = along[:, :3], along[:, 3:]
        self.spring = stiffness[:, None] * self.normal
        planes = grasp.tangential_arrangement()
        self.class_of = np.array(planes.class_of, dtype=np.int64)
        self.orientation = np.array(planes.orientation, dtype=np.float64)
        first = [members[0] for members in planes.distinct]
        self.plane = self.tangent[first].reshape(-1, 3)

    @cached_property
    def stiffness_terms(self) -> tuple[Floats, Floats]:
        """``k N N'`` and ``k mu T N'`` of each contact, as rows of 9."""
        m = len(self.normal)
        pulled = self.friction[:, None] * self.tangent
        return tuple(  # type: ignore[return-value]
            (v[:, :, None] * self.spring[:, None, :]).reshape(m, 9) for v in (self.normal, pulled)
        )

    @cached_property
    def preload_terms(self) -> tuple[Floats, Floats]:
        """``q N`` and ``q mu T`` of each contact."""
        loaded = self.preload[:, None]
        return loaded * self.normal, loaded * self.friction[:, None] * self.tangent

    @property
    def relative_error(self) -> float:
        """Of a sum over the contacts of any of these terms, relative to the sum of their sizes.

        A term has four rounded factors and three products; two sums of m terms are subtracted:
        m + 8 roundings, taken four times.
        """
        return error_bound(4 * (len(self.normal) + 8) - 2)
