"""Whether a certificate is a true proof, decided without the checker of certificates.

Slow and plain. The faces of the motion arrangement come from exact linear programs, plane by
plane, where the checker counts by Zaslavsky's theorem; which states have to be refuted comes from
the meaning of the states on each face, where the checker derives them from the regions.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cache
from typing import Any

from equilibrium import Grasp

from . import oracle

Vector = list[Fraction]
Signs = tuple[int, ...]


def is_true_proof(document: dict[str, Any]) -> bool:
    """Return whether a certificate of readable form proves what it says."""
    grasp, wrench = statement(document)
    if document["certificate"] == "stable":
        forces = tuple(tuple(_fractions(pair)) for pair in document["forces"])
        return oracle.satisfies(grasp, wrench, tuple(_fractions(document["motion"])), forces)
    branches = document["branches"]
    return (
        _is_true_list(grasp, document["regions"])
        and all(_is_true_reason(grasp, wrench, *branch) for branch in branches.items())
        and _covers(grasp, set(branches))
    )


def statement(document: dict[str, Any]) -> tuple[Grasp, tuple[Fraction, ...]]:
    return Grasp.from_dict(document["grasp"]), tuple(_fractions(document["wrench"]))


def _covers(grasp: Grasp, listed: set[str]) -> bool:
    """Whether, for each face, the conditions of some listed states hold for every equilibrium.

    On a face the slip has a sign, and the contact touches or not. A contact that just touches
    (gap 0) has no force, so the conditions of all states fit that its slip allows.
    """
    half = len(grasp)

    def fits(letter: str, slip: int, gap: int) -> bool:
        if letter == "d":
            return gap >= 0
        return gap <= 0 and (letter == {1: "+", 0: "0", -1: "-"}[slip] or _idle(letter, slip, gap))

    return all(
        any(all(map(fits, states, face[:half], face[half:])) for states in listed)
        for face in faces(grasp)
    )


def _idle(letter: str, slip: int, gap: int) -> bool:
    """Whether a contact that does not slip and has no force satisfies a state of slip."""
    return gap == 0 and slip == 0 and letter in "+-"


def _is_true_list(grasp: Grasp, regions: list[list[Any]]) -> bool:
    """Whether these are all regions, each once and each with a point inside."""
    listed = []
    for text, *point in regions:
        x, y, r, scale = _fractions(point)
        signs = tuple({"+": 1, "-": -1}[letter] for letter in text)
        if not scale or signs != _signs(grasp, [x / scale, y / scale, r / scale]):
            return False
        listed.append(signs)
    return sorted(listed) == sorted(face for face in faces(grasp) if 0 not in face)


@cache
def faces(grasp: Grasp) -> frozenset[Signs]:
    """Return the signs of all faces over the slips of all contacts, then their gaps.

    Plane by plane. A face is convex: with a point on either side of a plane it has one in it, and
    with one in it, it has points on both sides or lies in the plane.
    """
    known: dict[Signs, Vector] = {(): [Fraction(0)] * 3}
    planes = _planes(grasp)
    for count, plane in enumerate(planes):
        found: dict[Signs, Vector] = {}
        for face, point in known.items():
            for sign in (1, 0, -1):
                if sign == _sign(_value(plane, point)):
                    found[*face, sign] = point
                else:
                    other = _strict_point(planes[: count + 1], (*face, sign))
                    if other is not None:
                        found[*face, sign] = other
        known = found
    return frozenset(known)


def _strict_point(planes: list[Vector], signs: Signs) -> Vector | None:
    """Return a point with these signs.

    A strict system has a solution exactly when its cone has one with "at least 1" for "more than
    0"; the fourth unknown is the scale of the cone.
    """
    equal: list[list[int]] = [[0] * 5]
    least: list[list[int]] = [[0, 0, 0, 1, -1]]
    for plane, sign in zip(planes, signs, strict=True):
        row = _whole([sign * x if sign else x for x in plane])
        (least if sign else equal).append([*row, -1 if sign else 0])
    found = oracle._point(equal, least, 4)
    return None if found is None else [x / found[3] for x in found[:3]]


def _planes(grasp: Grasp) -> list[Vector]:
    """Return the slips, then ``stiffness gap - preload``, as rows over (x, y, r, 1)."""
    slips, gaps = [], []
    for contact in grasp:
        (px, py), (nx, ny) = contact.point, contact.normal
        slips.append([-ny, nx, px * nx + py * ny, Fraction(0)])
        gaps.append([contact.stiffness * g for g in (nx, ny, px * ny - py * nx)])
        gaps[-1].append(-contact.preload)
    return [*slips, *gaps]


def _signs(grasp: Grasp, motion: Vector) -> Signs:
    return tuple(_sign(_value(plane, motion)) for plane in _planes(grasp))


def _is_true_reason(grasp: Grasp, wrench: tuple, letters: str, reason: Any) -> bool:
    """Whether a reason shows that the conditions of these states have no solution."""
    if isinstance(reason, str):
        kind, number = reason.split(" ")
        return _fails(grasp, wrench, letters, kind, int(number))
    y, x = (_fractions(reason[key]) for key in ("inequalities", "equalities"))
    return _refutes(grasp, wrench, letters, y, x)


def _refutes(grasp: Grasp, wrench: tuple, letters: str, y: Vector, x: Vector) -> bool:
    """Whether the multipliers combine the conditions to -1, by substitution.

    A combination of affine functions is -1 everywhere when it is so at 0 and at the unit vectors.
    """
    if any(multiplier < 0 for multiplier in y):
        return False
    size = 3 + letters.count("0")
    for j in range(-1, size):
        point = [Fraction(int(i == j)) for i in range(size)]
        equal, least = _conditions(grasp, wrench, letters, point)
        if len(y) != len(least) or len(x) != len(equal):
            return False
        if sum(map(math.prod, zip([*y, *x], [*least, *equal], strict=True))) != -1:
            return False
    return True


def _conditions(
    grasp: Grasp, wrench: Sequence[Fraction], letters: str, point: Vector
) -> tuple[Vector, Vector]:
    """Return the values of equalities and inequalities at a point, in the documented order."""
    motion, free = point[:3], iter(point[3:])
    planes, m = _planes(grasp), len(grasp)
    balance, sticks, least = list(wrench), [], []
    for i, (contact, letter) in enumerate(zip(grasp, letters, strict=True)):
        normal, moved = -_value(planes[m + i], motion), _value(planes[i], motion)
        if letter == "d":
            least.append(-normal)
            continue
        limit = contact.friction * normal
        if letter == "0":
            tangential = next(free)
            sticks.append(moved)
            least += [normal, limit - tangential, limit + tangential]
        else:
            sign = 1 if letter == "+" else -1
            tangential = -sign * limit
            least += [normal, sign * moved]
        balance = [w + f for w, f in zip(balance, _push(contact, normal, tangential), strict=True)]
    return [*balance, *sticks], least


def _push(contact: Any, normal: Fraction, tangential: Fraction) -> Vector:
    """Return the wrench of a contact force."""
    (px, py), (nx, ny) = contact.point, contact.normal
    fx, fy = normal * nx - tangential * ny, normal * ny + tangential * nx
    return [fx, fy, px * fy - py * fx]


def _fails(grasp: Grasp, wrench: tuple, letters: str, kind: str, contact: int) -> bool:
    """Whether the equalities have one solution and the named condition fails at it.

    The unknowns are the motion and, for each tangential plane with sticking contacts, the sum of
    their forces along the tangent of the first of them.
    """
    groups = _groups(grasp, letters)
    size = 3 + len(groups)
    corners = [[Fraction(int(i == j)) for i in range(size)] for j in range(-1, size)]
    zero, *units = (_equalities(grasp, wrench, letters, groups, z) for z in corners)
    rows = [_whole([*(u[i] - zero[i] for u in units), zero[i]]) for i in range(len(zero))]
    reduced, pivots = oracle._eliminated(rows)
    if pivots != list(range(size)):
        return False
    z = [Fraction(-row[-1], row[j]) for j, row in enumerate(reduced[:size])]
    planes, m, letter = _planes(grasp), len(grasp), letters[contact]
    touch, moved = -_value(planes[m + contact], z), _value(planes[contact], z)
    if kind == "normal":
        return touch > 0 if letter == "d" else touch < 0
    if kind == "slip":
        return (letter == "+" and moved < 0) or (letter == "-" and moved > 0)
    if letter != "0":
        return False
    place, group = next((j, g) for j, g in enumerate(groups) if contact in g)
    limit = sum(grasp.contacts[i].friction * -_value(planes[m + i], z) for i in group)
    along = z[3 + place] * _same_way(grasp, group[0], contact)
    return limit + (along if kind == "friction+" else -along) < 0


def _groups(grasp: Grasp, letters: str) -> list[list[int]]:
    """Return the sticking contacts by tangential plane."""
    groups: list[list[int]] = []
    for i, letter in enumerate(letters):
        if letter == "0":
            group = next((g for g in groups if _same_way(grasp, g[0], i)), None)
            if group is None:
                groups.append([i])
            else:
                group.append(i)
    return groups


def _same_way(grasp: Grasp, i: int, j: int) -> int:
    """Return 1 or -1 when the slips of two contacts are equal or opposite, else 0."""
    planes = _planes(grasp)
    opposite = [-x for x in planes[j]]
    return 1 if planes[i] == planes[j] else -1 if planes[i] == opposite else 0


def _equalities(
    grasp: Grasp, wrench: tuple, letters: str, groups: list[list[int]], z: Vector
) -> Vector:
    """Return the balances, then one slip for each group."""
    balance, planes, m = list(wrench), _planes(grasp), len(grasp)
    first = {group[0]: z[3 + j] for j, group in enumerate(groups)}
    for i, (contact, letter) in enumerate(zip(grasp, letters, strict=True)):
        if letter == "d":
            continue
        normal = -_value(planes[m + i], z)
        sign = {"+": -1, "-": 1, "0": 0}[letter]
        tangential = first.get(i, sign * contact.friction * normal)
        balance = [w + f for w, f in zip(balance, _push(contact, normal, tangential), strict=True)]
    return [*balance, *(_value(planes[group[0]], z) for group in groups)]


def _value(row: Vector, point: Vector) -> Fraction:
    return sum((a * x for a, x in zip(row[:3], point[:3], strict=True)), row[3])


def _sign(value: Fraction) -> int:
    return (value > 0) - (value < 0)


def _fractions(texts: Iterable[Any]) -> Vector:
    return [Fraction(text) for text in texts]


def _whole(row: Vector) -> list[int]:
    scale = math.lcm(*(x.denominator for x in row))
    return [int(scale * x) for x in row]
