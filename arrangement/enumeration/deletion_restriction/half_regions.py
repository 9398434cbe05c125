"""Regions of many arrangements of hyperplanes through the origin: signs, and points in floats."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from arrangement.numbers.float_filter import UNIT
from arrangement.numbers.packing import Words, chunks, unpack

from .restrictions import Arrangements, Floats, Places

#: Numbers that are multiplied at once.
PORTION = 1 << 18


class TooCloseError(ArithmeticError):
    """A witness is so near a hyperplane that floats do not tell its side."""


@dataclass(frozen=True, slots=True)
class HalfRegions:
    """Regions of some arrangements, on the positive side of the first hyperplanes of each.

    Attributes:
        signs: (R, W), bit k is set if the region is on the positive side of hyperplane k.
        points: (R, d), a point of each, with largest entry 1.
        of: (R,), the arrangement of each.
    """

    signs: Words
    points: Floats
    of: Places

    def chosen(self, rows: Places) -> HalfRegions:
        """Return some of the regions."""
        return HalfRegions(self.signs[rows], self.points[rows], self.of[rows])


def sectors(lines: Arrangements, units: Words) -> HalfRegions:
    """Return the sectors between lines through the origin of R^2, on one side of the first."""
    starts, owner = lines.starts, lines.owners()
    if not len(owner):
        return HalfRegions(units[:0], lines.floats, owner)
    first = starts[owner]
    number = np.arange(len(owner)) - first
    rays = np.stack([-lines.floats[:, 1], lines.floats[:, 0]], axis=1)
    above = np.where(number > 0, dot(rays, lines.floats[first]), 1.0)
    if not above.all():
        raise TooCloseError
    rays *= np.sign(above)[:, None]
    along = np.where(number > 0, dot(rays, rays[first]) / np.abs(above), -np.inf)
    order = np.lexsort((along, owner))
    rays = rays[order] / np.sqrt(dot(rays, rays))[order, None]
    ends = np.append(starts[1:], len(owner)) - 1
    after = np.roll(rays, -1, axis=0)
    after[ends] = rays[starts]
    rays[starts] *= -1
    points = rays + after
    alone = starts[lines.sizes == 1]
    points[alone] = lines.floats[alone]
    # From one sector to the next the sign at the line between them changes.
    changes = units[number[order]]
    on_this_side = np.where((above > 0)[:, None], units[number], np.uint64(0))
    changes[starts] = np.add.reduceat(on_this_side, starts, axis=0)
    signs = np.bitwise_xor.accumulate(changes, axis=0)
    signs[ends[0] + 1 :] ^= np.repeat(signs[ends[:-1]], lines.sizes[1:], axis=0)
    return _kept(HalfRegions(signs, scaled(points), owner), lines, units)


def _kept(found: HalfRegions, lines: Arrangements, units: Words) -> HalfRegions:
    """Return those of all regions that are on the positive side of the first hyperplanes."""
    several = np.flatnonzero(lines.sides[found.of] > 1)
    if not len(several):
        return found
    check(found.chosen(several), lines)
    sides = np.cumsum(units, axis=0)[lines.sides - 1][found.of]
    return found.chosen(np.flatnonzero(((found.signs & sides) == sides).all(axis=1)))


def dot(left: Floats, right: Floats) -> Floats:
    """Return the scalar products along the last axis, summed over it in order."""
    found: Floats = left[..., 0] * right[..., 0]
    for k in range(1, right.shape[-1]):
        found += left[..., k] * right[..., k]
    return found


def scaled(points: Floats) -> Floats:
    """Return the points, each divided by its largest entry."""
    size: Floats = np.abs(points).max(axis=1, keepdims=True)
    if not size.all():
        raise TooCloseError
    found: Floats = points / size
    return found


def margin(d: int) -> float:
    """Return a bound on the error of a scalar product of a point and a normal.

    Their entries are at most 1, those of the normal with an error of one rounding: a sum of d
    products has an error below d (d + 2) roundings.
    """
    return 2 * d * (d + 2) * UNIT


def check(found: HalfRegions, arrangements: Arrangements) -> None:
    """Compare every sign of every point with a bound on its rounding error."""
    d, m = arrangements.dimension, int(arrangements.sizes.max(initial=1))
    starts, last, least = arrangements.starts, len(arrangements.floats) - 1, margin(d)
    for part in chunks(len(found.of), max(1, PORTION // (m * d))):
        of = found.of[part]
        rows = np.minimum(starts[of, None] + np.arange(m), last)
        products = dot(found.points[part, None], arrangements.floats[rows])
        sides = unpack(found.signs[part], m)
        sure = np.where(sides, products > least, products < -least)
        if not (sure | (np.arange(m) >= arrangements.sizes[of, None])).all():
            raise TooCloseError
