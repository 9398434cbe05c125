"""Which virtual motions close regions of motions: many at once, guessed in floats, then exactly.

A virtual motion lambda closes a simplicial region when at each of its four generators the work of
the load and the least work of the contacts add up to something positive. What is found here is a
guess with small integers; `closed` decides, exactly.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from arrangement.numbers.exact import IntegerVector, RationalVector, primitive
from arrangement.numbers.float_filter import Booleans, Floats
from arrangement.numbers.linear.float_dictionary import FloatDictionary
from equilibrium.core.contacts import FloatContacts, IntegerContacts, nearest, product, whole
from equilibrium.core.float_law import Batch

#: Entries of the virtual motions tried first.
_MAX_FIRST_ENTRY = 2
#: What counts as 0, in units of the works.
_TOLERANCE = 1e-12
#: Multipliers of bounded displacements have denominators up to this where that will do.
_MAX_DENOMINATOR = 2**16
#: What a sum of works of the size 1 may lose where virtual motion and multipliers are rounded.
_ROUNDED_WORK = 2.0
#: Steps from a virtual motion to those around it.
_NEIGHBOURS = np.array([x for x in itertools.product((-1, 0, 1), repeat=3) if any(x)], dtype=float)


class VirtualMotions:
    """The works of virtual motions for one question.

    Attributes:
        arm: what one unit of a turn is divided by, a power of 2.
        candidates: (L, 3), small integers in these units.
    """

    def __init__(self, contacts: IntegerContacts, wrench: RationalVector) -> None:
        self.contacts: FloatContacts = contacts.floats
        self.load = np.array([nearest(w) for w in wrench])
        self.arm = 2.0 ** round(math.log2(self.contacts.length))
        entries = range(-_MAX_FIRST_ENTRY, _MAX_FIRST_ENTRY + 1)
        every = itertools.product(entries, repeat=3)
        # The simplest first: where two do equally well, that one is taken.
        listed = sorted((x for x in every if math.gcd(*x) == 1), key=lambda x: sum(map(abs, x)))
        self.candidates = np.array(listed, dtype=float)
        self.works = self._works(self.candidates)

    def _works(self, motions: Floats, used: Any = slice(None)) -> tuple[Floats, ...]:
        """Return for (..., L, 3) virtual motions in units: the columns of those of length 1, works.

        These are the least works of a unit spring force at each contact, (..., m, L): sliding
        either way; and, where they are below 0, either way, +, -.
        """
        c = self.contacts
        real = motions / np.array([1.0, 1.0, self.arm])
        columns = np.swapaxes(real / np.linalg.norm(motions, axis=-1, keepdims=True), -1, -2)
        works = [edge[used] @ columns for edge in c.edges]
        either = np.minimum(*works)
        lows = (np.minimum(x, 0.0) for x in (either, *works))
        return columns, either, *lows

    def values(self, regions: Regions, motions: Floats | None = None) -> Floats:
        """Return (R, L): positive where a virtual motion seems to close a region.

        Args:
            motions: (R, L, 3) for each region, or None for the candidates.
        """
        mixed, slip = regions.mixed, regions.slip
        kinds = regions.open & ~mixed, mixed & (slip == 0), mixed & (slip > 0), mixed & (slip < 0)
        used = np.flatnonzero(regions.open.any(axis=0))
        columns, *works = self.works if motions is None else self._works(motions, used)
        total = regions.linear @ columns
        for of, least in zip(kinds, works, strict=True):
            # Deep down few contacts are mixed, and few may slip either way.
            if (chosen := of.any(axis=0)).any():
                rows = chosen if motions is None else chosen[used]
                pressed = regions.lifted[:, :, chosen] * of[:, None, chosen]
                total += pressed @ least[..., rows, :]
        if regions.beyond.any():
            total -= _multiplier(total, regions.beyond[:, :, None]) * regions.beyond[:, :, None]
        far = (regions.weight == 0)[:, :, None]
        total = np.where(far & (total > -_TOLERANCE), np.inf, total - _TOLERANCE)
        value: Floats = np.nan_to_num(total.min(axis=1), nan=-1.0)
        return value

    def best(self, regions: Regions, rounds: int = 0) -> tuple[Floats, Floats]:
        """Return for each region the best virtual motion found, (R, 3), and its value."""
        values = self.values(regions)
        chosen = np.argmax(values, axis=1)
        motions = self.candidates[chosen]
        value = values[np.arange(len(values)), chosen]
        for _ in range(rounds):
            open_ = np.flatnonzero(value <= 0)
            if not len(open_):
                break
            near = 2 * motions[open_, None, :] + _NEIGHBOURS
            sums = self.values(regions[open_], near)
            best = np.argmax(sums, axis=1)
            best_value = sums[np.arange(len(best)), best]
            better = best_value > value[open_]
            motions[open_] = np.where(
                better[:, None], near[np.arange(len(best)), best], 2 * motions[open_]
            )
            value[open_] = np.maximum(value[open_], best_value)
        return motions, value

    def multiplied(self, regions: Regions, n: int) -> tuple[Floats, Floats] | None:
        """Return integers that seem to close a region: a virtual motion, multipliers of contacts.

        A linear program guesses them. Of a contact that the region does not decide, which does at
        least ``kappa`` times its normal force, it has ``u <= kappa`` as a difference of two numbers
        of at least 0; they count as u times the spring where u > 0, else the normal force. All
        conditions have room for what rounding changes, so thin cones give longer integers.
        """
        arms = np.array([1.0, 1.0, self.arm])
        used = np.flatnonzero(regions.open[n])
        count, base = len(used), regions.linear[n] / arms
        works = np.hstack([regions.spring[n][:, used], -regions.lifted[n][:, used], base])
        works /= np.maximum(np.abs(works).sum(axis=1, keepdims=True), 1e-300)
        room = np.where((regions.weight[n] > 0) | base.any(axis=1), _ROUNDED_WORK, 0.0)
        kappas = np.concatenate([edge[used] for edge in self.contacts.edges]) / arms
        unit, rounded = np.tile(np.eye(count), (2, 1)), np.abs(kappas).sum(axis=1) / 2
        possible = np.concatenate([regions.slip[n, used] >= 0, regions.slip[n, used] <= 0])
        limits = np.column_stack([-unit, unit, kappas, -rounded])[possible]
        program = FloatDictionary(
            np.concatenate([np.column_stack([works, -room]), limits]), signed=2 * count
        )
        if program.start() != -1 or not np.isfinite(program.point).all():
            return None
        point = program.point
        factors = np.floor(point[:count] - point[count : 2 * count])
        multipliers = np.zeros(len(self.contacts.normal))
        multipliers[used] = np.where(regions.mixed[n, used], np.maximum(factors, 0.0), 0.0)
        return np.rint(point[-3:]), multipliers * max(self.arm, 1.0)

    def integers(self, motion: Sequence[float]) -> tuple[int, int, int]:
        """Return integers of the same direction, in the coordinates of the object."""
        x, y, r = (round(v) for v in motion)
        return (
            (x * int(self.arm), y * int(self.arm), r)
            if self.arm >= 1
            else (x, y, r * int(1 / self.arm))
        )


class Regions(Batch):
    """Simplicial cones of homogeneous motions in floating point.

    Attributes:
        weight: (R, 4), the entries d_0 of generators scaled to a common length.
        spring: (R, 4, m), the spring force at the generators; lifted: the same where it presses.
        mixed, open: (R, m), where it changes sign, and where that or the slip is not decided.
        slip: (R, m), the sign of the slip where it is the same everywhere, else 0.
        linear: (R, 4, 3), the wrench of the load and of contacts that touch and slip one way.
        size: (R,), about the largest works.
        beyond: (R, 4), a row of bounded displacements at the generators, below 0 at some, or zeros;
            row: (R,), which row that is.
    """

    def __init__(
        self, contacts: FloatContacts, load: Floats, generators: Floats, beyond: Floats, row: Any
    ) -> None:
        self.beyond, self.row, self.weight = beyond, row, generators[..., 0]
        self.spring = contacts.spring_forces_at(generators)
        self.lifted = np.maximum(self.spring, 0.0)
        shift = generators[..., 1:] @ contacts.tangent.T
        touching = self.spring.min(axis=1) >= -_TOLERANCE
        self.mixed = (self.spring.max(axis=1) > _TOLERANCE) & ~touching
        self.slip = np.where(shift.min(axis=1) > _TOLERANCE, 1, 0) - np.where(
            shift.max(axis=1) < -_TOLERANCE, 1, 0
        )
        self.open = self.mixed | (touching & (self.slip == 0))
        self.linear = self.weight[..., None] * load
        for sign, edge in zip((1, -1), contacts.edges, strict=True):
            decided = touching & (self.slip == sign)
            self.linear = self.linear + (self.lifted * decided[:, None]) @ edge
        self.size = np.linalg.norm(load) * self.weight.max(axis=1)
        self.size += self.lifted.sum(axis=2).max(axis=1)


def _multiplier(work: Floats, beyond: Floats) -> Floats:
    """Return the multiplier of a row that leaves works above 0 at all generators, if one does.

    It takes the multiple of the row from the works, (R, 4, L), and the row is below 0 at some.
    """
    with np.errstate(all="ignore"):
        ratio = work / beyond
    low = np.where(beyond < -_TOLERANCE, ratio, 0.0).max(axis=1, keepdims=True)
    high = np.where(beyond > _TOLERANCE, ratio, np.inf).min(axis=1, keepdims=True)
    low = np.maximum(low, 0.0)
    middle: Floats = np.where(high == np.inf, 2 * low, (low + high) / 2)
    return np.where((low > 0) & (low < high), middle, 0.0)


def closed(
    contacts: IntegerContacts,
    wrench: RationalVector,
    regions: Sequence[Sequence[IntegerVector]],
    motions: Sequence[Sequence[int]],
    factors: Floats,
    rows: Sequence[int] = (),
) -> list[Fraction | None]:
    """Return for each region whether the virtual motion beside it closes it, exactly.

    That is 0 where it does, or a multiplier of a row of bounded displacements with which it does,
    or None.

    Args:
        factors: (R, m), integers; of a contact with one above 0 that, times e, is its least work,
            if it is at most kappa.

    The contacts' least work for the spring force e is ``kappa e``: kappa is the work of an edge of
    the friction cone where the contact surely slips one way, else the lesser one of both. Where e
    changes sign in the region it is 0, or ``kappa max(0, e)`` for kappa < 0. A virtual motion
    closes a region if at each generator the work of the load and all these add up to a positive
    number, or to 0 or more at unbounded motions (d_0 = 0).
    """
    count, m = len(regions), len(contacts)
    generators = whole(regions, (count, 4, 4))
    chosen = whole(motions, (count, 3))
    spring = product(generators.reshape(-1, 4), contacts.spring.T).reshape(count, 4, m)
    slip = product(generators[:, :, 1:].reshape(-1, 3), contacts.tangent.T).reshape(count, 4, m)
    one, other = (product(chosen, edge.T) for edge in contacts.edges)
    kappa = np.where((slip > 0).all(axis=1), one, np.minimum(one, other))
    kappa = np.where((slip < 0).all(axis=1), other, kappa)
    low, high = spring.min(axis=1, initial=0), spring.max(axis=1, initial=0)
    mixed = (low < 0) & (high > 0)
    scaled = whole([[int(x) for x in row] for row in factors.tolist()], (count, m))
    scaled = contacts.edge_unit * scaled
    broken: Booleans = np.any(scaled > np.maximum(kappa, 0), axis=1)
    kappa = np.where((high <= 0) | (mixed & (kappa > 0)), 0, kappa)
    terms = kappa[:, None, :] * np.where(spring > 0, spring, 0)
    terms = np.where(scaled[:, None, :] > 0, scaled[:, None, :] * spring, terms)
    unit = contacts.common_unit
    load = primitive([*wrench, 1])
    work = terms.astype(object).dot(contacts.shares) * load[3]
    work = work + (chosen.dot(whole([load[:3]], (3,))) * unit)[:, None] * generators[:, :, 0]
    passed = np.where(generators[:, :, 0] > 0, work > 0, work >= 0).all(axis=1) & ~broken
    multipliers: list[Fraction | None] = [Fraction(0) if good else None for good in passed]
    for n, k in enumerate(rows):
        if multipliers[n] is None and not broken[n]:
            beyond = generators[n].dot(contacts.bounds[0][k]).tolist()
            unit = contacts.common_unit * load[3]
            number = _exact_multiplier(work[n].tolist(), beyond, generators[n, :, 0].tolist())
            multipliers[n] = number and number / unit
    return multipliers


def _exact_multiplier(
    work: Sequence[int], beyond: Sequence[int], weight: Sequence[int]
) -> Fraction | None:
    """Return a number that takes a multiple of a row from works and leaves all above 0, or None."""
    low = max((Fraction(x, y) for x, y in zip(work, beyond, strict=True) if y < 0), default=None)
    if low is None:
        return None
    low = max(low, Fraction(0))
    high = min((Fraction(x, y) for x, y in zip(work, beyond, strict=True) if y > 0), default=None)
    middle = 2 * low + 1 if high is None else (low + high) / 2
    for number in (middle.limit_denominator(_MAX_DENOMINATOR), middle):
        left = [x - number * y for x, y in zip(work, beyond, strict=True)]
        if number > 0 and all(
            x > 0 or (x == 0 and not w) for x, w in zip(left, weight, strict=True)
        ):
            return number
    return None
