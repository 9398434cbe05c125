"""The equilibrium of one choice of contact states, solved exactly from a guess.

Where more contacts stick than the balance needs, their forces are not determined. All but a few
get a rounded share of their friction limit, which is linear in the motion and never too large; the
few whose tangential planes fix the motion carry what is missing.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction

import numpy as np

from arrangement.numbers.exact import RationalVector
from arrangement.numbers.float_filter import Floats
from arrangement.numbers.linear.rank import gauss_jordan, rank
from equilibrium.core.cones import SLIP_SHARE, LineCones
from equilibrium.core.contacts import IntegerContacts, product
from equilibrium.core.continuation import SHARPNESS_NEAR, Continuation
from equilibrium.core.float_law import Balance
from equilibrium.model.displacement import displacement
from equilibrium.model.solution import Solution

#: Shares of the friction limit are multiples of one over this.
_SHARE_DENOMINATOR = 2**14
#: Rounded motions are multiples of one over this.
_MOTION_DENOMINATOR = 16
#: The least weight of a contact that bears nothing.
_MIN_WEIGHT = 1e-6


@dataclass(frozen=True)
class Guess:
    """What each contact may do.

    Attributes:
        touching: the contacts with a normal force.
        sticking: those among them that do not slip.
        shares: of its friction limit, over `_SHARE_DENOMINATOR`, for each contact;
            exact when it slips.
        motion: over `_MOTION_DENOMINATOR`, rounded.
        weights: which of those that stick bear most, from `_MIN_WEIGHT` to 1.
    """

    touching: tuple[bool, ...]
    sticking: tuple[bool, ...]
    shares: tuple[int, ...]
    motion: tuple[int, ...] = field(compare=False)
    weights: tuple[float, ...] | float = field(default=1.0, compare=False)

    @classmethod
    def near(cls, balance: Balance, motion: Floats, eps: float) -> Guess:
        """Return the likely contact states near a motion of the smooth balance."""
        force, share = (numbers[:, 0] for numbers in balance.forces(motion, eps)[:2])
        touching = force > 0
        sticking = touching & ~(np.abs(share) > SLIP_SHARE)
        shares = np.where(
            sticking, np.rint(share * _SHARE_DENOMINATOR), np.sign(share) * _SHARE_DENOMINATOR
        )
        return cls(
            tuple(touching.tolist()),
            tuple(sticking.tolist()),
            tuple(int(x) for x in np.nan_to_num(shares).tolist()),
            tuple(round(x * _MOTION_DENOMINATOR) for x in np.nan_to_num(motion).tolist()),
            tuple(np.clip(np.nan_to_num(force / force.max(initial=0)), _MIN_WEIGHT, 1).tolist()),
        )


def find_equilibrium(
    contacts: IntegerContacts, wrench: RationalVector, start: Floats | None = None
) -> Solution | None:
    """Return an exact equilibrium, or None where the search finds none.

    Args:
        start: a motion that may be near one; the path then begins with rather sharp contacts.
    """
    search = Continuation(contacts.floats, wrench, LineCones())
    path = search.path(np.zeros(3)) if start is None else search.path(start, SHARPNESS_NEAR)
    tried: set[Guess] = set()
    with np.errstate(all="ignore"):
        for motion, eps in path:
            guess = Guess.near(search.balance, motion, eps)
            if guess not in tried:
                tried.add(guess)
                equilibrium = exact_equilibrium(contacts, wrench, guess)
                if equilibrium is not None:
                    return equilibrium
    return None


def exact_equilibrium(
    contacts: IntegerContacts, wrench: RationalVector, guess: Guess
) -> Solution | None:
    """Return an equilibrium with the states of a guess, or None."""
    pillars = _pillars(contacts, guess)
    along, across = contacts.balance
    shares = np.array(guess.shares, dtype=object)
    shares[pillars] = 0
    touching = np.array(guess.touching, dtype=bool)
    arm = (along * _SHARE_DENOMINATOR + across * shares[:, None])[touching]
    unit = contacts.common_unit * _SHARE_DENOMINATOR
    stiffness = product(arm.T, contacts.spring[touching])
    rows = []
    for j in range(3):
        pull = [int(contacts.tangent[i, j]) for i in pillars]
        constant = stiffness[j, 0] + wrench[j] * unit
        rows.append([*stiffness[j, 1:], *(unit * x for x in pull), constant])
    rows += [[*contacts.tangent[i], *[0] * len(pillars), 0] for i in pillars]
    size = 3 + len(pillars)
    reduced, pivots, scale = gauss_jordan(rows)
    if size in pivots:
        return None
    # What the equations leave open is taken from the guess.
    free = [j for j in range(size) if j not in pivots]
    point = [0] * size
    for j in free:
        point[j] = guess.motion[j] * scale if j < 3 else 0
    for row, pivot in zip(reduced, pivots, strict=False):
        point[pivot] = -row[size] * _MOTION_DENOMINATOR - sum(
            row[j] * point[j] // scale for j in free
        )
    if scale < 0:
        point, scale = [-x for x in point], -scale
    return _checked(contacts, wrench, guess, pillars, point, scale * _MOTION_DENOMINATOR)


def _pillars(contacts: IntegerContacts, guess: Guess) -> list[int]:
    """Return sticking contacts whose tangential wrenches are a basis of all sticking ones'.

    Those are taken that can give most, each across what the ones before it give.
    """
    sticking = np.flatnonzero(guess.sticking)
    tangents = contacts.floats.tangent[sticking]
    spare = 1.0 - np.abs(np.array(guess.shares)[sticking]) / (_SHARE_DENOMINATOR + 1)
    spare *= np.broadcast_to(guess.weights, len(contacts))[sticking]
    left = tangents * (spare * contacts.floats.friction[sticking])[:, None]
    chosen: list[int] = []
    while len(chosen) < 3 and len(sticking):
        size = np.linalg.norm(left, axis=1)
        best = int(np.argmax(size))
        if not size[best] > 1e-9 * np.linalg.norm(tangents[best]) * (spare[best] + 1e-9):
            break
        tried = [*chosen, int(sticking[best])]
        if rank(contacts.tangent[tried].tolist()) < len(tried):
            break
        unit = left[best] / size[best]
        left = left - np.outer(left @ unit, unit)
        chosen = tried
    return chosen


def _checked(
    contacts: IntegerContacts,
    wrench: RationalVector,
    guess: Guess,
    pillars: list[int],
    point: list[int],
    scale: int,
) -> Solution | None:
    """Return the solution if it satisfies the law, and its motion counts; ``point[:3] / scale``."""
    motion = np.array([scale, *point[:3]], dtype=object)
    force = contacts.spring.dot(motion)
    slip = contacts.tangent.dot(motion[1:])
    special = dict(zip(pillars, point[3:], strict=True))
    forces: list[tuple[Fraction, Fraction]] = []
    zero = Fraction(0)
    for i, (c, f, s) in enumerate(zip(contacts.grasp, force.tolist(), slip.tolist(), strict=True)):
        if f <= 0:
            if guess.touching[i] and f:
                return None
            forces.append((zero, zero))
            continue
        if not guess.touching[i]:
            return None
        normal = Fraction(f, contacts.spring_unit[i] * scale)
        limit = c.friction * normal
        if i in special:
            rub = Fraction(special[i] * contacts.wrench_unit[i], scale)
        else:
            rub = limit * Fraction(guess.shares[i], _SHARE_DENOMINATOR)
        if s and rub * s != -limit * abs(s):
            return None
        if abs(rub) > limit:
            return None
        forces.append((normal, rub))
    if any(force[i] <= 0 and special[i] for i in special):
        return None
    solution = Solution(tuple(Fraction(x, scale) for x in point[:3]), tuple(forces))
    most = contacts.max_displacement
    return (
        solution if most is None or displacement(contacts.grasp, solution.motion) <= most else None
    )
