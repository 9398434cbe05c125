"""The states of contacts in space at a motion in floats, and what balance with them asks for."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction

import numpy as np

from arrangement.numbers.exact import RationalVector
from arrangement.numbers.float_filter import Floats
from arrangement.numbers.linear.rank import null_space
from equilibrium.core.cones import SLIP_SHARE
from equilibrium.core.contacts import FloatContacts, nearest

#: Shares of the friction limit are multiples of one over this.
_SHARE_DENOMINATOR = 2**14
#: Rational slip directions have half-angle tangents with denominators up to this.
_MAX_TANGENT_DENOMINATOR = 64
#: How far such a tangent may be from that of the slip.
_TANGENT_ERROR = 1e-6
#: Beside others, forces below this are within the errors of floats.
_FORCE_TOLERANCE = 1e-6


class States:
    """What each contact does, read off normal forces (m,) and shares of friction limits (m, 2).

    Contacts without friction count as sticking ones with no share.

    Attributes:
        ratio: (m, 2), of friction forces to their limits; forces: (m, 3).
        touching, slipping: contacts with a force, and those among them that slip.
        shares: (m, 2), of the friction limit, rounded; those of slips only if they are rational.
        rational: whether all slips go along rational directions.
        key: touching and slipping contacts, and how much all rub, about.
        kind: the same, of which only rational slips rub in a certain way.
    """

    def __init__(self, contacts: FloatContacts, force: Floats, ratio: Floats) -> None:
        ratio = np.where(contacts.friction[:, None] > 0, ratio, 0.0)
        pressed = np.maximum(force, 0.0)
        self.forces = np.column_stack([pressed, ratio * (contacts.friction * pressed)[:, None]])
        self.touching = [bool(x) for x in force > 0]
        self.ratio = ratio
        size = np.linalg.norm(ratio, axis=1)
        self.slipping = [
            t and bool(x > SLIP_SHARE) for t, x in zip(self.touching, size, strict=True)
        ]
        self.shares: list[RationalVector | None] = []
        for (x, y), slips in zip(ratio, self.slipping, strict=True):
            if slips:
                self.shares.append(rational_direction(float(x), float(y)))
            else:
                self.shares.append(
                    tuple(Fraction(int(v * _SHARE_DENOMINATOR), _SHARE_DENOMINATOR) for v in (x, y))
                )
        self.rational = None not in self.shares
        near = tuple(np.rint(64 * ratio).astype(int).ravel().tolist())
        self.key = (tuple(self.touching), tuple(self.slipping), near)
        pairs = zip(self.slipping, self.shares, strict=True)
        self.kind = *self.key[:2], tuple(share if slip else None for slip, share in pairs)


def rational_direction(
    x: float, y: float, simple: int = _MAX_TANGENT_DENOMINATOR, error: float = _TANGENT_ERROR
) -> RationalVector | None:
    """Return the unit vector of a simple half-angle tangent in a direction, if there is one."""
    size = math.hypot(x, y)
    x, y = x / size, y / size
    folded = abs(y) / (1 + abs(x))
    u = Fraction(folded).limit_denominator(simple)
    if abs(float(u) - folded) > error:
        return None
    cosine, sine = (1 - u * u) / (1 + u * u), 2 * u / (1 + u * u)
    return (cosine if x > 0 else -cosine, sine if y > 0 else -sine)


def rubbing_states(
    contacts: FloatContacts, motion: Floats, forces: Floats, slipping: Sequence[bool], size: float
) -> tuple[Floats, States] | None:
    """Return a motion near, and states, where contacts that rub but hardly press slip; if any.

    With a friction of 10^12 a normal force that floats do not see allows any friction, so it does
    not decide whether a contact sticks. That these slip, by as little, opposite to their friction,
    is an equation for each motion, as regular as for small frictions.

    Args:
        forces: (m, 3), maybe of smaller frictions.
        size: of the forces that matter.
    """
    c, pull, least = contacts, np.hypot(*forces[:, 1:].T), _FORCE_TOLERANCE * size
    press = pull / np.maximum(c.friction, 1e-300)
    rubs = (pull > least) & (press < least) & (np.array(slipping) | (forces[:, 0] < least))
    rubs &= c.stiffness > 0
    if not rubs.any():
        return None
    normal = np.where(rubs, press, forces[:, 0])
    ratio = forces[:, 1:] / np.maximum(c.friction * normal, 1e-300)[:, None]
    moved = press[rubs] / c.stiffness[rubs]
    rows = np.concatenate([c.normal[rubs], *c.tangents[rubs].swapaxes(0, 1)])
    lifts = (c.spring_forces(motion) - press)[rubs] / c.stiffness[rubs]
    slips = -ratio[rubs] * moved[:, None] - c.slips(motion)[rubs]
    change = np.linalg.lstsq(rows, np.concatenate([lifts, *slips.T]), rcond=None)[0]
    return motion + change, States(c, normal, ratio)


class StateBalance:
    """The balance for given states, in y, of the motion B y, and forces of pillars."""

    def __init__(self, contacts: FloatContacts, wrench: RationalVector, states: States) -> None:
        self.contacts, self.wrench, self.states = contacts, wrench, states
        rows = contacts.rows
        self.sticking = [
            i
            for i, contact in enumerate(rows)
            if states.touching[i] and not states.slipping[i] and contact.friction
        ]
        still = [row for i in self.sticking for row in rows[i].tangential_wrenches]
        self.basis = null_space(still, rows.n)
        self.pillars = self._pillars(rows.n - len(self.basis))
        # Motions that no touching contact feels; balance does not determine them.
        touching = [c for c, near in zip(rows, states.touching, strict=True) if near]
        felt = [c.normal_wrench for c in touching]
        felt += [row for c in touching if c.friction for row in c.tangential_wrenches]
        self.unfelt = null_space(felt, rows.n)

    def _pillars(self, count: int) -> tuple[tuple[int, int], ...]:
        """Return tangents of sticking contacts that span all of them; strong contacts first."""
        c = self.contacts
        places = [(i, j) for i in self.sticking for j in (0, 1)]
        tangents = np.array([c.tangents[i, j] for i, j in places]).reshape(-1, c.rows.n)
        spare = [1.01 - float(np.linalg.norm(self.states.ratio[i])) for i, _ in places]
        weight = np.array(
            [x * (c.friction[i] + 1e-9) for x, (i, _) in zip(spare, places, strict=True)]
        )
        left = tangents * weight[:, None] if places else tangents
        return tuple(places[k] for k in spanning_rows(left, count))

    def share(self, i: int) -> list[Fraction]:
        """Return the share of a contact, without what pillars carry."""
        shares = self.states.shares[i] or (Fraction(0), Fraction(0))
        return [Fraction(0) if (i, j) in self.pillars else x for j, x in enumerate(shares)]

    def named_share(self, i: int) -> RationalVector | None:
        """Return None for a detached contact, nothing for one that may slip, else its share."""
        if not self.states.touching[i]:
            return None
        return tuple(self.share(i)) if i in self.sticking else ()

    def coordinates(self, motion: Floats) -> Floats:
        """Return the combination of the basis that is nearest to a motion."""
        if not self.basis:
            return np.zeros(0)
        basis = np.array([[nearest(x) for x in motion] for motion in self.basis])
        coefficients = np.linalg.lstsq(basis.T, motion, rcond=None)[0]
        nearest_one: Floats = coefficients.astype(np.float64)
        return nearest_one


def spanning_rows(rows: Floats, count: int) -> list[int]:
    """Return at most a number of independent rows, each the one furthest from those before."""
    left, chosen = rows, list[int]()
    for _ in range(count):
        size = np.linalg.norm(left, axis=1)
        best = int(np.argmax(size))
        if not size[best] > 0:
            break
        chosen.append(best)
        unit = left[best] / size[best]
        left = left - np.outer(left @ unit, unit)
    return chosen
