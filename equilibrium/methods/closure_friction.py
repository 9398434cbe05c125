"""The least uniform friction with which a grasp has force closure: a bracket with both proofs.

With larger cones closure stays. So forces that show it do so for all larger coefficients, and a
free motion shows for all smaller ones that there is none: each proof moves an end of the bracket to
where it just holds. In the plane, and in space on round cones.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import isqrt
from typing import Any

import numpy as np

from arrangement.console.number_form import JsonMixin
from arrangement.console.progress import watched
from arrangement.numbers.exact import (
    RationalVector,
    dot,
    exact_root,
    rational,
    shown,
    simplest_between,
)
from arrangement.numbers.float_filter import Floats
from arrangement.numbers.linear.programs import Infeasible, feasible_point
from equilibrium.certificate.law import closure_problem, escape_problem
from equilibrium.methods.springs import Forces
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp

from .force_closure import force_closure, unfelt_motion

#: Of the bracket, if none is stated.
TOLERANCE = Fraction(1, 10**6)
#: Larger coefficients are not asked about.
_LARGEST = 2**20


@dataclass(frozen=True, repr=False)
class ClosureFriction(JsonMixin):
    """Where the least coefficient for force closure lies; the same at all contacts.

    Attributes:
        low: up to this coefficient there is no closure, proved by `free_motion`; None: with
            none at all. It is 0, without a motion, where there is closure without friction.
        high: from this coefficient on there is closure, proved by `forces`; None where none was
            found.
        free_motion: on which no force inside any cone does negative work with friction `low`.
        forces: balanced, strictly inside the cones with friction `high`.
    """

    json_fields = ("low", "high", "impossible", "free_motion", "forces")

    low: Fraction | None
    high: Fraction | None
    free_motion: RationalVector | None = None
    forces: Forces | None = None

    @property
    def impossible(self) -> bool:
        """Whether no coefficient is enough; proved by `free_motion`."""
        return self.low is None

    def verify(self, grasp: Grasp) -> bool:
        """Check both proofs again, by `equilibrium.certificate.law`.

        A motion that no friction opposes is checked with one that no contact force opposes.
        """
        low = Fraction(_LARGEST) if self.low is None else self.low
        motion, forces = self.free_motion, self.forces
        is_free = motion is None or not escape_problem(grasp.with_friction(low), motion)
        if self.low is None:
            assert motion is not None
            is_free &= not any(dot(t, motion) for c in grasp for t in c.tangential_wrenches)
        high = self.high or Fraction(0)
        is_closed = forces is None or not closure_problem(grasp.with_friction(high), forces)
        return is_free and is_closed and (motion is not None or self.low == self.high == 0)


def closure_friction(grasp: Grasp, tolerance: Any = TOLERANCE) -> ClosureFriction:
    """Bracket the least friction coefficient, the same at all contacts, for force closure.

    Args:
        tolerance: the wanted length of the bracket. It comes out longer where closure is undecided.

    Raises:
        GraspError: a tolerance that is not above 0.
        MissingExtraError: in space, where a cone program has to decide and is not installed.

    Complexity: some ten to twenty decisions of force closure.

    >>> from equilibrium import Contact
    >>> ends = [([-1, 0], ["12/13", "5/13"]), ([1, 0], ["-12/13", "5/13"])]
    >>> pair = Grasp(Contact(point, normal, 1) for point, normal in ends)
    >>> found = closure_friction(pair)                # their line is 5/12 off the normals
    >>> found.low, found.verify(pair)
    (Fraction(5, 12), True)
    """
    width = rational(tolerance, "tolerance")
    if width <= 0:
        raise GraspError(f"tolerance is {shown(width)}; it must be above 0")
    if (motion := _motion_without_slip(grasp)) is not None:
        return ClosureFriction(None, None, motion)
    bracket = _asked(grasp, ClosureFriction(Fraction(0), None), Fraction(0), width)
    coefficient = Fraction(1)
    while bracket.high is None and coefficient <= _LARGEST:
        bracket, coefficient = _asked(grasp, bracket, coefficient, width), 2 * coefficient
    while (
        bracket.high is not None and bracket.low is not None and bracket.high - bracket.low > width
    ):
        length = bracket.high - bracket.low
        for share in (Fraction(1, 2), Fraction(1, 4), Fraction(3, 4), Fraction(1, 10)):
            middle = bracket.low + share * length
            # Short numbers are more often where closure ends.
            at = simplest_between(middle - length / 20, middle + length / 20)
            narrower = _asked(grasp, bracket, at, width)
            if narrower != bracket:
                bracket = narrower
                break
        else:
            break
    return bracket


def closure_frictions(grasps: Sequence[Grasp], tolerance: Any = TOLERANCE) -> Floats:
    """Return the brackets of many grasps, (G, 2) floats rounded outwards.

    Both ends are inf where no coefficient is enough, and the second where none was found.
    """
    brackets = np.full((len(grasps), 2), np.inf)
    for row, grasp in zip(brackets, watched(grasps, "grasps", len(grasps)), strict=True):
        bracket = closure_friction(grasp, tolerance)
        for k, (end, outwards) in enumerate(((bracket.low, -1), (bracket.high, 1))):
            if end is not None:
                row[k] = float(end)
                if (Fraction(row[k]) - end) * outwards < 0:
                    row[k] = np.nextafter(row[k], outwards * np.inf)
    return brackets


def _asked(
    grasp: Grasp, known: ClosureFriction, coefficient: Fraction, width: Fraction
) -> ClosureFriction:
    """Return a bracket after closure with one coefficient is asked about."""
    closure = force_closure(grasp.with_friction(coefficient), pyramids=False)
    fine = width / 8
    if closure.forces is not None:
        shares = [dot(x[1:], x[1:]) / x[0] ** 2 for x in closure.forces if any(x)]
        least = _root(max(shares), fine) + fine if coefficient else Fraction(0)
        high = min(coefficient, simplest_between(least, least + fine) if least else least)
        return ClosureFriction(known.low, high, known.free_motion, closure.forces)
    motion = closure.free_motion
    if motion is None:
        return known
    low = coefficient
    pairs = [
        (dot(c.normal_wrench, motion) ** 2, sum(dot(t, motion) ** 2 for t in c.tangential_wrenches))
        for c in grasp
    ]
    if shares := [push / slip for push, slip in pairs if slip]:
        low = max(low, _root(min(shares), fine))
    return ClosureFriction(low, known.high, motion, known.forces)


def _root(square: Fraction, fine: Fraction) -> Fraction:
    """Return a root, exact where it is rational, else rounded down by at most a small number."""
    if (exact := exact_root(square)) is not None:
        return exact
    unit = -(-2 // fine)
    return Fraction(isqrt(square.numerator * unit**2 // square.denominator), unit)


def _motion_without_slip(grasp: Grasp) -> RationalVector | None:
    """Return a motion other than 0 on which no contact slips or is pressed; None if there is none.

    It is free with every coefficient; and if there is none, a large one is enough: motions that are
    free are closed sets of directions, smaller with larger coefficients, and none is in all.
    """
    if (motion := unfelt_motion(grasp.with_friction(1))) is not None:
        return motion
    normals = [[*c.normal_wrench, Fraction(0)] for c in grasp]
    slips = [[*t, Fraction(0)] for c in grasp for t in c.tangential_wrenches]
    total = [sum(column, Fraction(0)) for column in zip(*normals, strict=True)]
    total[-1] = Fraction(-1)
    point = feasible_point(grasp.wrench_size, normals, [*slips, total])
    return None if isinstance(point, Infeasible) else point
