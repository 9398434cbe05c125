"""Proofs of a verdict for all grasps within bounds, in intervals that are rounded outwards.

Normals turn by an angle t up to a bound: ``n' = cos t n + sin t u`` for a unit vector u across n,
and tangents turn along; here cosines and sines are taken as independent numbers of their ranges.
Points, friction, stiffness and preload have ranges of their own.

"Not resisted": the regions of a tree do not depend on the grasp; its leaves must hold for all.
"Resisted": unknowns are the motion d and friction forces z of some sticking contacts ("pillars"),
equations are the balance and ``T . d = 0`` at pillars. If the test of Krawczyk (see
`equilibrium.certificate.enclosure`) maps a box into itself for all grasps at once, each has a
solution in it; the law must hold in the whole box. Other sticking contacts have fixed shares of
their limits; then the pillars must be as many as motions have dimensions, so that d = 0.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product as choices
from typing import Any, NamedTuple

from arrangement.console.number_form import Shown
from arrangement.numbers.exact import RationalVector, dot, rational, shown
from equilibrium.model.contact import Contact
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp

from .enclosure import BrokenLaw, Interval, Linear, interval, product, total, unit_slip
from .reading import Split, read_node, read_plane

_ZERO = Interval(0, 0)


@dataclass(frozen=True, repr=False)
class Bounds(Shown):
    """How far grasps may be from one that is given.

    Attributes:
        degrees: of each normal, up to 45.
        length: of each coordinate of a point.
        friction, stiffness, preload: shares of the values, below 1.

    >>> Bounds(degrees=2, friction="5%").friction
    Fraction(1, 20)
    """

    degrees: Fraction = Fraction(0)
    length: Fraction = Fraction(0)
    friction: Fraction = Fraction(0)
    stiffness: Fraction = Fraction(0)
    preload: Fraction = Fraction(0)

    def __init__(self, **given: Any) -> None:
        most = {"degrees": 45, "length": 10**9}
        for name in ("degrees", "length", "friction", "stiffness", "preload"):
            value = given.pop(name, 0)
            percent = isinstance(value, str) and value.endswith("%")
            found = rational(value.removesuffix("%") if percent else value, name)
            found /= 100 if percent else 1
            if not 0 <= found <= most.get(name, Fraction(99, 100)):
                raise GraspError(
                    f"{name} is {shown(value)}; give a number from 0 to "
                    f"{most.get(name, '0.99, a share of the value as 0.05 or 5%')}"
                )
            object.__setattr__(self, name, found)
        if given:
            raise GraspError(
                f"{shown(min(given))} is no bound; known are degrees, length, friction, stiffness "
                "and preload"
            )

    @property
    def angle(self) -> Fraction:
        """A little more than `degrees` in radians."""
        return self.degrees * Fraction(355, 113 * 180)

    def __str__(self) -> str:
        angle, length = (f"{float(x):g}" for x in (self.degrees, self.length))
        words = [f"normals within {angle} degrees"] if self.degrees else []
        words += [f"points within {length}"] if self.length else []
        for name in ("friction", "stiffness", "preload"):
            if share := getattr(self, name):
                words.append(f"{name} within {float(100 * share):g} per cent")
        return ", ".join(words) or "no change"


class Ranges(NamedTuple):
    """What a contact may be: wrenches of unit forces along normal and tangents, and values."""

    rows: tuple[tuple[Interval, ...], ...]
    friction: Interval
    stiffness: Interval
    preload: Interval


def _around(x: Fraction, away: Fraction) -> Interval:
    return Interval(interval(x - away).low, interval(x + away).high)


def ranges_of(contact: Contact, bounds: Bounds) -> Ranges:
    """Return the ranges of a contact."""
    axes, turn = (contact.normal, *contact.tangents), bounds.angle
    near, away = _around(Fraction(1), Fraction(0)), _around(Fraction(0), turn)
    near = Interval(interval(1 - turn * turn / 2).low, near.high)
    slight = _around(Fraction(0), turn * turn / 2)
    point = [_around(x, bounds.length) for x in contact.point]
    rows = []
    for j in range(len(axes)):
        shares = [near if k == j else away if 0 in (j, k) else slight for k in range(len(axes))]
        along = [
            product(shares, [interval(x) for x in column]) for column in zip(*axes, strict=True)
        ]
        pairs = [(0, 1)] if len(point) == 2 else [(1, 2), (2, 0), (0, 1)]
        torque = [
            point[a].times(along[b]).plus(point[b].times(along[a]).negative()) for a, b in pairs
        ]
        rows.append((*along, *torque))
    values = (
        _around(x, x * share)
        for x, share in (
            (contact.friction, bounds.friction),
            (contact.stiffness, bounds.stiffness),
            (contact.preload, bounds.preload),
        )
    )
    return Ranges(tuple(rows), *values)


def refuted_within(grasp: Grasp, wrench: RationalVector, tree: Any, bounds: Bounds) -> str:
    """Return why a tree does not show "not resisted" for all grasps within bounds, or nothing."""
    if read_plane(tree) is not None:
        return "tree: the contacts of other grasps are not in one plane"
    contacts, n = [ranges_of(contact, bounds) for contact in grasp], len(wrench)
    axes = [(0, 1), *choices(range(1, n + 1), (1, -1))]
    region = [tuple(sign * (j == axis) for j in range(n + 1)) for axis, sign in axes]
    waiting = [(tree, "tree", region)]
    while waiting:
        content, path, region = waiting.pop()
        node = read_node(content, path, len(grasp), 2 if n == 3 else 3)
        if not isinstance(node, Split):
            if node.multipliers or not _holds(contacts, wrench, node.motion, region):
                return f"{path}: the leaf does not hold for all grasps"
        elif node.kind == "edge" and len(region) == 4:
            j, k, p, q = node.at
            pairs = zip(region[j], region[k], strict=True)
            middle = tuple(p * x + q * y for x, y in pairs)
            for old, (name, child) in zip((j, k), node.children, strict=True):
                waiting.append((child, name, [*region[:old], middle, *region[old + 1 :]]))
        elif node.kind == "orthants" and len(region) == 7:
            corners = choices(region[1:3], region[3:5], region[5:7])
            for corner, (name, child) in zip(corners, node.children, strict=True):
                waiting.append((child, name, [region[0], *corner]))
        else:
            return f"{path}: splits of states are not checked for all grasps"
    return ""


def _holds(
    contacts: Sequence[Ranges],
    wrench: RationalVector,
    virtual: RationalVector,
    region: Sequence[Sequence[int]],
) -> bool:
    """Return whether a leaf holds for all contacts; see `equilibrium.certificate.checker`."""
    motions = [[interval(x) for x in generator] for generator in region]
    virtually = [interval(x) for x in virtual]
    work = [interval(dot(wrench, virtual) * generator[0]).low for generator in region]
    for contact in contacts:
        normal, *across = (product(row, virtually) for row in contact.rows)
        moved = [[product(row, g[1:]) for row in contact.rows] for g in motions]
        springs = [
            contact.preload.times(g[0]).plus(contact.stiffness.times(rows[0]).negative())
            for g, rows in zip(motions, moved, strict=True)
        ]
        if all(e.high <= 0 for e in springs):
            continue
        largest = sum(max(map(abs, b)) ** 2 for b in across)
        size = math.isqrt(largest) + 1 if largest else 0
        rubs = Interval(-size, size)
        if len(across) == 1 and all(rows[1].low > 0 for rows in moved):
            rubs = across[0]
        elif len(across) == 1 and all(rows[1].high < 0 for rows in moved):
            rubs = across[0].negative()
        kappa = normal.plus(contact.friction.times(rubs).negative()).low
        if any(e.low < 0 for e in springs):
            kappa = min(kappa, 0)
            springs = [Interval(0, max(e.high, 0)) for e in springs]
        least = Interval(kappa, kappa)
        work = [
            w + least.times(Interval(*[e.low if kappa > 0 else e.high] * 2)).low
            for w, e in zip(work, springs, strict=True)
        ]
    return all(w > 0 or w == 0 == g[0] for w, g in zip(work, region, strict=True))


class Steady(NamedTuple):
    """What is claimed of an equilibrium for all grasps: for a motion in a box around `centre`.

    Attributes:
        states: None where a contact is detached, () where it slips, else the shares of its friction
            limit along the tangents.
        pillars: sticking contacts and tangents with an unknown force.
        centre, inverse: of the box, and a matrix near the inverse of the derivative.
    """

    states: tuple[RationalVector | None, ...]
    pillars: tuple[tuple[int, int], ...]
    centre: RationalVector
    inverse: tuple[RationalVector, ...]


def resisted_within(grasp: Grasp, wrench: RationalVector, given: Steady, bounds: Bounds) -> str:
    """Return why there may be no equilibrium for some grasp within bounds, or nothing."""
    contacts = [ranges_of(contact, bounds) for contact in grasp]
    pillars, n = set(given.pillars), len(wrench)
    sticking = {
        (i, j)
        for i, share in enumerate(given.states)
        for j in range(len(grasp.contacts[i].tangents))
        if share
    }
    if not pillars <= sticking or (pillars != sticking and len(pillars) != n):
        return "not all sticking contacts are known to stick"
    if any(share and dot(share, share) > 1 for share in given.states):
        return "a share of friction is above 1"
    centre = [interval(x) for x in given.centre]
    inverse = [[interval(x) for x in row] for row in given.inverse]
    radius = [0] * len(centre)
    try:
        value = [row.value for row in _equations(contacts, wrench, given, centre)]
        step = [product(row, value).negative() for row in inverse]
        for _ in range(12):
            box = [Interval(m.low - r, m.high + r) for m, r in zip(centre, radius, strict=True)]
            slopes = [row.slopes for row in _equations(contacts, wrench, given, box)]
            found = []
            for j, row in enumerate(inverse):
                rest = [
                    interval(int(j == k)).plus(product(row, column).negative())
                    for k, column in enumerate(zip(*slopes, strict=True))
                ]
                away = (Interval(-r, r) for r in radius)
                found.append(total((step[j], product(rest, away))))
            if all(-r < x.low <= x.high < r for x, r in zip(found, radius, strict=True)):
                return ""
            radius = [max(map(abs, x)) * 9 // 8 + 2**40 for x in found]
            if max(radius) > 2**240:
                break
    except BrokenLaw as broken:
        return str(broken)
    return "no box of motions is mapped into itself"


def _equations(
    contacts: Sequence[Ranges], wrench: RationalVector, given: Steady, box: Sequence[Interval]
) -> list[Linear]:
    """Return balance and the slip of pillars over a box.

    Raises:
        BrokenLaw: a condition does not hold for all.
    """
    n, size = len(wrench), len(box)
    sums = [Linear(interval(w), [_ZERO] * size) for w in wrench]
    still = []
    for i, (contact, share) in enumerate(zip(contacts, given.states, strict=True)):
        moved = [
            Linear(product(row, box[:n]), [*row, *[_ZERO] * (size - n)]) for row in contact.rows
        ]
        normal = _scaled(moved[0], contact.stiffness.negative())
        normal = Linear(normal.value.plus(contact.preload), normal.slopes)
        if share is None:
            if normal.value.high > 0:
                raise BrokenLaw(f"contact {i + 1} may touch")
            continue
        if normal.value.low < 0:
            raise BrokenLaw(f"contact {i + 1} may let go")
        limit = _scaled(normal, contact.friction)
        if share:
            forces = [limit.by(x) for x in share]
            for k, (pillar, j) in enumerate(given.pillars, n):
                if pillar == i:
                    unit = [interval(int(k == other)) for other in range(size)]
                    forces[j] = forces[j].plus(Linear(box[k], unit))
                    still.append(moved[1 + j])
            if total(force.value.square() for force in forces).high > limit.value.square().low:
                raise BrokenLaw(f"contact {i + 1} may slip")
        elif len(moved) == 2:
            if moved[1].value.low <= 0 <= moved[1].value.high:
                raise BrokenLaw(f"contact {i + 1} may stick")
            forces = [limit.by(-1 if moved[1].value.low > 0 else 1)]
        else:
            forces = [limit.times(x).by(-1) for x in unit_slip(i, moved[1:])]
        for force, row in zip((normal, *forces), contact.rows, strict=True):
            sums = [one.plus(_scaled(force, x)) for one, x in zip(sums, row, strict=True)]
    return [*sums, *still]


def _scaled(number: Linear, factor: Interval) -> Linear:
    return Linear(number.value.times(factor), [x.times(factor) for x in number.slopes])
